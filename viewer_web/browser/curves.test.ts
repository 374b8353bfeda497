import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import {
  cutOff,
  goTo,
  open,
  openFile,
  opened,
  placesOf,
  sampleTrace,
  shown,
  widthOf,
} from './page.js';

const name = 'hills.floating-horizon.signs.jsonl';
const hills = sampleTrace('hills.floating-horizon.signs');

async function openHills(
  hash = '#lang=en',
  options: Parameters<typeof open>[2] = {},
): Promise<{ page: Page; faults: readonly string[] }> {
  const { page, faults } = await open(browser, hash, options);
  await opened(page, name, hills);
  return { page, faults };
}

/** The number of the first step, counted from `from`, whose line in the file matches. */
const stepOf = (pattern: RegExp, from = 1): number =>
  hills.split('\n').findIndex((line, i) => i >= from && pattern.test(line));

const shapes = (page: Page, look: string): Promise<number> =>
  page.locator(`vidno-curve-picture > svg > path.${look}`).count();

/** Clicks a column of the picture: the area is 14 columns wide, from -2 on. */
async function clickColumn(page: Page, x: number): Promise<void> {
  const area = await page.locator('vidno-curve-picture .area').boundingBox();
  if (area === null) throw new Error('no picture');
  await page.mouse.click(area.x + ((x + 2) * area.width) / 14, area.y + area.height / 2);
}

describe('a run of curves', () => {
  it('is replayed in the terms of the algorithm, with the listing', async () => {
    const { page, faults } = await openHills();
    await goTo(page, stepOf(/"visibility","at":"FH5".*"flag":0/));
    expect(await shown(page)).toMatchObject({
      line: 'FH5',
      sentence: expect.stringContaining(
        'hidden (0): it is strictly between the horizons',
      ) as string,
    });
    expect(await page.locator('vidno-horizon dl').first().innerText()).toContain('0, hidden');
    await page.getByRole('button', { name: 'C++' }).click();
    expect(await page.locator('vidno-cpp').getByText('run.visibility(FH5').count()).toBe(1);
    await page.getByRole('button', { name: 'C++' }).click();
    await page.keyboard.press('End');
    expect((await shown(page)).line).toBe('FH10');
    expect(faults).toEqual([]);
  });

  it('speaks the horizons over the column under the cursor', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const name = 'crossing.floating-horizon.signs';
    await opened(page, `${name}.jsonl`, sampleTrace(name));
    await page.keyboard.press('End');
    await page.keyboard.press('p');
    for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowLeft');
    // A line at 1.5 and one from 3 to -1 over the columns 0 to 4. Heights grow downward.
    const heard = page.locator('vidno-curve-picture [aria-live]');
    expect(await heard.textContent()).toBe('Column 0: upper horizon 1.5, lower horizon 3');
    for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
    expect(await heard.textContent()).toBe('Column 4: upper horizon −1, lower horizon 1.5');
    expect(faults).toEqual([]);
  });

  it('of the printed text ends with a verdict that says so', async () => {
    const run = '15-floating-horizon.floating-horizon.double.printed-x-h1.signs';
    const { page, faults } = await open(browser, `#lang=en&trace=${run}`);
    await page.locator('.title h2', { hasText: /./u }).waitFor();
    await page.keyboard.press('End');
    // Its arithmetic is right, and its lines are wrong.
    await expect
      .poll(() => page.locator('.verdict').textContent())
      .toBe(
        'Finished: 4 curves; every decision as in exact arithmetic, but this is not the corrected text.',
      );
    expect(faults).toEqual([]);
  });

  it('steps over and out of its procedures', async () => {
    const { page } = await openHills();
    const call = stepOf(/"call","at":"FH5"/);
    await goTo(page, call - 1);
    await page.getByRole('button', { name: 'Over the call', exact: true }).click();
    expect((await shown(page)).step).toBe(stepOf(/"visibility"/, call));
    await goTo(page, call);
    await page.getByRole('button', { name: 'Out of the procedure, to its result' }).click();
    expect((await shown(page)).step).toBe(stepOf(/"visibility"/, call));
  });

  it('shows what is switched on', async () => {
    const { page } = await openHills();
    await goTo(page, stepOf(/"curve":3/) + 20);
    const looks = ['visible', 'current', 'upper', 'lower', 'flag', 'side-edge', 'looked-at'];
    for (const look of looks) expect([look, await shapes(page, look)]).not.toEqual([look, 0]);
    await page.getByLabel('horizons', { exact: true }).uncheck();
    expect(await shapes(page, 'upper')).toBe(0);
    await page.keyboard.press('l');
    expect(await shapes(page, 'visible')).toBe(1);
    expect(await shapes(page, 'current')).toBe(0);
    await page.keyboard.press('l');
    expect(await shapes(page, 'current')).toBe(1);
  });

  it('has no pixels, no 3D view and no exact picture', async () => {
    const { page, faults } = await openHills();
    await goTo(page, stepOf(/"visibility"/));
    await page.locator('vidno-curve-picture > svg').focus();
    await page.keyboard.press('v');
    await page.keyboard.press('x');
    expect(await page.locator('vidno-solid, vidno-layers').count()).toBe(0);
    expect(await page.locator('vidno-exactness h3').first().innerText()).toBe(
      'The flag of Visibility',
    );
    expect(faults).toEqual([]);
  });
});

it('a checked run of curves ends with the number of steps that decide wrongly', async () => {
  // Two wrong decisions follow the first flag, and one follows the second.
  const disagree =
    '{"e":"disagree","at":"FH5","of":"visibility","taken":0,"exact":1,"cause":"drifted"}';
  const lines = hills.trim().split('\n').slice(0, -1);
  const [first = 0, second = 0] = lines.flatMap((line, i) =>
    line.includes('"e":"visibility"') ? [i] : [],
  );
  lines.splice(second + 1, 0, disagree);
  lines.splice(first + 1, 0, disagree, disagree);
  const end = { end: { events: lines.length - 1, lines: `sha256:${'0'.repeat(64)}` } };
  const { page } = await open(browser, '#lang=en');
  await opened(page, 'wrong.jsonl', [...lines, JSON.stringify(end), ''].join('\n'));
  await page.keyboard.press('End');
  await expect
    .poll(async () => (await shown(page)).sentence)
    .toMatch(/; wrong decisions at 2 steps\./u);
});

describe('an incomplete run of curves', () => {
  it.each(['windows', 'polygons'])('is shown with what it has, at level %s', async (detail) => {
    const { page, faults } = await open(browser, '#lang=en');
    const file = `hills.floating-horizon.${detail}`;
    await opened(page, `${file}.jsonl`, sampleTrace(file));
    const { length } = await shown(page);
    for (const step of [1, Math.floor(length / 2), length]) {
      await goTo(page, step);
      // At the end, once the run was compared.
      await expect.poll(async () => (await shown(page)).sentence).toMatch(/\.$/u);
    }
    await clickColumn(page, 4);
    await page.locator('vidno-history .entries').waitFor();
    expect(await shapes(page, 'visible')).toBe(1);
    expect(faults).toEqual([]);
  });

  it('is shown empty, if it has no curves', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const header = JSON.parse(hills.split('\n')[0] ?? '') as { scene: object };
    const scene = { ...header.scene, curves: [] };
    const lines = [
      { ...header, scene },
      { e: 'horizons', at: 'FH1' },
    ];
    const end = { end: { events: 1, lines: `sha256:${'0'.repeat(64)}` } };
    const text = [...lines, end].map((line) => `${JSON.stringify(line)}\n`).join('');
    await opened(page, 'none.jsonl', text);
    await page.locator('vidno-curve-picture').waitFor();
    await page.keyboard.press('End');
    expect((await shown(page)).step).toBe(1);
    expect(faults).toEqual([]);
  });

  it('is refused with a sentence where it is impossible', async () => {
    const { page } = await open(browser, '#lang=en');
    const text = hills.replace('"curve","at":"FH2","curve":1', '"curve","at":"FH2","curve":7');
    await openFile(page, 'wrong.jsonl', text);
    await page.locator('vidno-notice', { hasText: 'no curve of the scene' }).waitFor();
  });
});

describe('the history of a column', () => {
  it('is opened by a click, and goes to its steps', async () => {
    const { page, faults } = await openHills();
    await clickColumn(page, 4);
    const headings = page.locator('vidno-history h3');
    expect(await headings.allInnerTexts()).toEqual(['Curve 0', 'Curve 1', 'Curve 2', 'Curve 3']);
    const step = stepOf(/"visibility".*"x":4,/);
    await page.locator(`vidno-history li[data-step="${step}"] button`).click();
    expect((await shown(page)).step).toBe(step);
    expect(await shapes(page, 'chosen-column')).toBe(1);
    expect(new URL(page.url()).hash).toContain('lang=en');
    expect(faults).toEqual([]);
  });

  it('is chosen by keyboard alone', async () => {
    const { page } = await openHills();
    await page.keyboard.press('p');
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Enter');
    const button = page.locator('vidno-side button[aria-pressed=true]');
    expect(await button.textContent()).toContain('Column 10');
  });
});

describe('with a run of curves', () => {
  it('the page is accessible', async () => {
    const { page } = await openHills('#lang=ru');
    await goTo(page, 200);
    expect(await violations(page)).toEqual([]);
    await clickColumn(page, 4);
    expect(await violations(page)).toEqual([]);
  });

  it('nothing is clipped or moves at any width', async () => {
    const { page } = await openHills('#lang=ru');
    for (const width of [390, 768, 1280, 1920]) {
      await page.setViewportSize({ width, height: width < 500 ? 844 : 1080 });
      const places = new Set<string>();
      for (const step of [0, 1, 60, 200, 373]) {
        await goTo(page, step);
        places.add(
          await placesOf(page, 'vidno-horizon section, .dock, .listing, vidno-curve-picture'),
        );
        expect(await widthOf(page)).toBe(width);
        const cut = await cutOff(page, 'vidno-horizon :is(dt, th, td:nth-child(2))');
        expect(cut, `at ${width} px`).toEqual([]);
      }
      expect([...places], `at ${width} px`).toHaveLength(1);
    }
  });
});
