import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser, emptyPage } from './browser.js';
import { edit, handle, openScene, rerun, scene, title } from './live.js';
import { goTo, open, shown, whole } from './page.js';
import { temporaryFile } from './temporary.js';
import { Meter, median, told } from './timing.js';
import type { Measured } from './timing.js';

/**
 * Compares the cost of a step and of a corner's move, and the time until each is seen, with a page that shows nothing. A busy
 * machine slows both down. This command prints all figures:
 *
 *     npx vitest run --config vitest.browser.config.ts browser/frame.test.ts
 */
const root = fileURLToPath(new URL('../..', import.meta.url));
const program = process.env['VIDNO_PROGRAM'] ?? join(root, 'build/release/trace/vidno');

const steps = 60;
/** Measured keys that one page gets before it is the other's turn. */
const turn = 20;
/** With one key more in each turn, which is not measured: a page that was hidden draws everything again. */
const pressed = steps + steps / turn;
const viewport = { width: 1440, height: 900 };
/** Milliseconds of processor time for a step or a move. A busy machine needs several times what an idle one needs. */
const patience = 100;

/** The teapot from its mesh, run by Warnock's algorithm: 900 000 events. */
function teapot(): string {
  const [file, trace] = [temporaryFile('teapot.json'), temporaryFile('teapot.jsonl')];
  const mesh = join(root, 'lessons/meshes/teapot.obj');
  const run = (...args: readonly string[]): Buffer =>
    execFileSync(program, args, { stdio: 'pipe' });
  run('import', mesh, '--width', '200', '--height', '200', '-o', file);
  run('trace', file, '--detail', 'polygons', '-o', trace);
  return trace;
}

/** Steps on from the current step, in turn with a page that shows nothing. */
async function stepOn(page: Page, name: string): Promise<readonly Measured[]> {
  const empty = await emptyPage(browser, { viewport });
  const sides = await Promise.all(
    [page, empty].map(async (of) => ({ of, meter: await Meter.of(of), found: [] as Measured[] })),
  );
  for (let i = 0; i < steps; i += turn) {
    for (const { of, meter, found } of sides) {
      await of.bringToFront();
      const step = (): Promise<Measured> =>
        meter.measure('keydown', () => of.keyboard.press('ArrowRight'));
      await step();
      for (let n = 0; n < turn; n++) found.push(await step());
    }
  }
  const [own = [], other = []] = sides.map(({ found }) => found);
  console.log(`${name}: ${told(own)}\nan empty page: ${told(other)}`);
  return own;
}

const costOf = (all: readonly Measured[]): number => median(all.map(({ cost }) => cost.task));

describe('a step', () => {
  it('of the first lesson takes one frame', async () => {
    const { page, faults } = await open(browser, '#lang=en', { viewport });
    await page.locator(title, { hasText: /./u }).waitFor();
    await whole(page);
    await goTo(page, 300);
    await page.locator(title).click();
    const found = await stepOn(page, 'lesson 1');
    expect((await shown(page)).step).toBe(300 + pressed);
    expect(costOf(found)).toBeLessThan(patience);
    expect(faults).toEqual([]);
  });

  it('of 900 000 events takes one frame', async () => {
    const { page, faults } = await open(browser, '#lang=en', { viewport });
    await page.locator('vidno-file-drop input').setInputFiles(teapot());
    await page.locator(title, { hasText: 'teapot' }).waitFor();
    await whole(page);
    expect((await shown(page)).length).toBeGreaterThan(900_000);
    await goTo(page, 450_000);
    await page.locator(title).click();
    const found = await stepOn(page, '900 000 events');
    expect((await shown(page)).step).toBe(450_000 + pressed);
    expect(costOf(found)).toBeLessThan(patience);
    expect(faults).toEqual([]);
  });
});

const polygon = (id: string, color: string, ...vertices: readonly (readonly number[])[]) => ({
  id,
  color,
  vertices,
});

/** An area of 32 x 32 pixels. Five polygons overlap, and two of them pierce others. */
const five = scene(
  [
    polygon('A', '#e69f00', [3, 4, 0], [20, 3, 0.25], [12, 22, 0.5]),
    polygon('B', '#0072b2', [10, 8, 0.5], [28, 8, 0], [28, 24, 0], [10, 24, 0.5]),
    polygon('C', '#009e73', [2, 18, 0.25], [16, 14, 0.25], [18, 29, 0.25], [5, 30, 0.25]),
    polygon('D', '#cc79a7', [18, 2, 0.1], [30, 6, 0.1], [22, 18, 0.6]),
    polygon('E', '#56b4e9', [6, 12, 0.7], [14, 10, 0.2], [25, 28, 0.1]),
  ],
  32,
);

describe('a corner that is dragged', () => {
  it.each(['zbuffer', 'warnock'])('is followed by a run of %s', async (method) => {
    const { page, faults } = await open(browser, '#lang=en', { viewport });
    await openScene(page, five);
    await edit(page);
    if (method !== 'warnock') {
      const choice = page.locator('vidno-run-form select[name=method]');
      await rerun(page, () => choice.selectOption(method));
    }
    await page.locator(title).click();
    await page.keyboard.press('End');
    const box = await page.locator(`${handle(0, 1)} .knob`).boundingBox();
    if (box === null) throw new Error('no corner');
    let [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    const meter = await Meter.of(page);
    const found: Measured[] = [];
    for (let i = 0; i < steps; i++) {
      x += i % 20 < 10 ? -5 : 5;
      y += i % 10 < 5 ? 4 : -4;
      found.push(await meter.measure('pointermove', () => page.mouse.move(x, y)));
    }
    await page.mouse.up();
    console.log(`a corner dragged, ${method}: ${told(found)}`);
    expect(costOf(found)).toBeLessThan(patience);
    expect(faults).toEqual([]);
  });
});
