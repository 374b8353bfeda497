import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { openScene } from './live.js';
import { goTo, open, shown } from './page.js';

const waves = readFileSync(
  new URL('../../lessons/surfaces/waves-and-pit.json', import.meta.url),
  'utf8',
);
/** A line at height 2, and behind it a line from 3 to 1: they cross halfway. */
const crossing = JSON.stringify({
  format: 'vidno-surface/1',
  name: 'Two lines that cross',
  window: { x: 0, y: 0, width: 5, height: 5 },
  curves: [
    [
      [0, 2],
      [4, 2],
    ],
    [
      [0, 3],
      [4, 1],
    ],
  ],
});

async function openSurface(text: string): Promise<Page> {
  const { page } = await open(browser, '#lang=en');
  await openScene(page, text);
  return page;
}

type Curves = readonly (readonly (readonly [number, number | null])[])[];

const curvesOf = (page: Page): Promise<Curves> =>
  page.evaluate(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    return player?.trace?.header.scene.curves ?? [];
  });

const lines = (page: Page): Promise<readonly unknown[]> =>
  page.evaluate(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    const { timeline } = player?.trace ?? {};
    const all = timeline?.linesAt(timeline.length) ?? [];
    return all.map(({ curve, from, to }) => [curve, from, to]);
  });

describe('a surface that the page runs', () => {
  it('has the lines that the procedures draw', async () => {
    const page = await openSurface(crossing);
    // The second line is 3 - x / 2. It meets the first, at height 2, over column 2.
    await expect
      .poll(() => lines(page))
      .toEqual([
        [0, [0, 2], [4, 2]],
        [1, [0, 3], [4, 1]],
      ]);
  });

  it('is run again when a sample is moved by keys, and when that is undone', async () => {
    const page = await openSurface(crossing);
    await page.keyboard.press('e');
    const handle = page.locator('vidno-sample-handles [data-spot="0,1"]');
    await handle.focus();
    for (let i = 0; i < 4; i++) await page.keyboard.press('Shift+ArrowUp');
    await expect.poll(async () => (await curvesOf(page))[0]?.[1]).toEqual([4, -2]);
    await page.keyboard.press('Control+z');
    await expect.poll(async () => (await curvesOf(page))[0]?.[1]).toEqual([4, 2]);
  });

  it('follows the mouse with a sample', async () => {
    const page = await openSurface(crossing);
    await page.keyboard.press('e');
    const area = await page.locator('vidno-curve-picture .area').boundingBox();
    const box = await page.locator('vidno-sample-handles [data-spot="0,0"]').boundingBox();
    if (area === null || box === null) throw new Error('no picture');
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 5, y + area.height / 5, { steps: 4 });
    await page.mouse.up();
    await expect.poll(async () => (await curvesOf(page))[0]?.[0]).toEqual([0, 3]);
  });

  it('is given by a function, which can be changed; an invalid one is refused with a reason', async () => {
    const page = await openSurface(waves);
    await page.keyboard.press('e');
    const field = page.locator('vidno-surface-form [name=function]');
    await field.fill('cot(x)');
    await field.press('Enter');
    await page
      .locator('vidno-scene-panel .refused', { hasText: 'cot: no such function' })
      .waitFor();
    await field.fill('0 * x');
    await field.press('Enter');
    // Then a curve is a straight line in the view: the nearest one from row 105 to row 165.
    await expect.poll(async () => (await curvesOf(page))[0]?.at(-1)).toEqual([220, 165]);
    expect((await curvesOf(page)).length).toBe(41);
  });

  it('can be started from nothing, and is part of a link', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await page.getByRole('button', { name: 'Your own scene' }).click();
    await page.getByRole('button', { name: 'A surface y = f(x, z)' }).click();
    await page.locator('vidno-surface-form').waitFor();
    await page.waitForFunction(() => location.hash.includes('scene='));
    const { page: again } = await open(browser, new URL(page.url()).hash);
    await again.locator('.title h2', { hasText: 'Surface' }).waitFor();
    expect(await curvesOf(again)).toEqual(await curvesOf(page));
    expect(faults).toEqual([]);
  });

  it('has an accessible editor', async () => {
    const page = await openSurface(waves);
    await page.keyboard.press('e');
    await page.locator('vidno-surface-form').waitFor();
    expect(await violations(page)).toEqual([]);
  });

  it('is compared with the printed text', async () => {
    const page = await openSurface(waves);
    await page.keyboard.press('d');
    await page.locator('vidno-rival-choice [name=printed]').click();
    await page.locator('vidno-compared-run.other .name h3').waitFor();
    await page.keyboard.press('End');
    const facts = page.locator('vidno-comparison-facts .differ');
    await expect.poll(() => facts.innerText()).toMatch(/Columns that differ.*at the end/su);
    expect(await facts.innerText()).not.toMatch(/\b0 at the end/u);
    await page.getByLabel('Mark them').check();
    expect(await page.locator('vidno-curve-picture path.rival').count()).toBe(2);
    expect(await violations(page)).toEqual([]);
  });
});

/** The samples of the same file by the program. */
const traced = join(process.env['VIDNO_STATES'] ?? '', 'waves-and-pit.jsonl');

describe.runIf(existsSync(traced))('the samples of a function', () => {
  it('equal those of the program, except for the last bits of sines and powers', async () => {
    const [first = ''] = readFileSync(traced, 'utf8').split('\n');
    const { scene } = JSON.parse(first) as { scene: { curves: Curves } };
    const page = await openSurface(waves);
    const own = await curvesOf(page);
    const columns = (curves: Curves): unknown => curves.map((curve) => curve.map(([x]) => x));
    expect(columns(own)).toEqual(columns(scene.curves));
    // The view enlarges the error of a sine or power, one ulp, 60 times. Rows up to 200 have an ulp of 2^-45.
    const ulp = 2 ** -45;
    own.forEach((curve, i) =>
      curve.forEach(([x, y], j) => {
        const there = scene.curves[i]?.[j]?.[1] ?? NaN;
        expect([x, Math.abs((y ?? NaN) - there) <= 4 * ulp]).toEqual([x, true]);
      }),
    );
    await goTo(page, 1);
    expect((await shown(page)).line).toBe('FH1');
  });
});
