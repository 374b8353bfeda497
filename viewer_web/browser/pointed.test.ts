import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { shapes } from './live.js';
import { goTo, open, opened, sampleTrace, small } from './page.js';

/** The elements that light up in a part of the page, by their names. */
const lit = (page: Page, part: string): Promise<readonly string[]> =>
  page
    .locator(`${part} .pointed[data-thing]`)
    .evaluateAll((all) => all.map((each) => (each as HTMLElement).dataset['thing'] ?? ''));

/** Points at the middle of a name. A locator's box would include its scaled outline. */
async function pointAt(page: Page, label: string): Promise<void> {
  const [x, y] = await page.locator(label).evaluate((each) => {
    const { left, right, top, bottom } = each.getBoundingClientRect();
    return [(left + right) / 2, (top + bottom) / 2] as const;
  });
  await page.mouse.move(x, y);
}

const halo = async (page: Page): Promise<number> =>
  (await shapes(page)).filter(({ look }) => look === 'casing pointed' || look === 'dot pointed')
    .length;

describe('a polygon that is pointed at', () => {
  it('in the list lights up in the picture and in the stack, until the mouse leaves', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await goTo(page, 200);
    await page.locator('vidno-warnock .apl tr').first().hover();
    await expect.poll(() => halo(page)).toBe(1);
    const [thing = ''] = await lit(page, 'vidno-warnock .apl');
    expect(thing).toMatch(/^polygon /);
    expect(new Set(await lit(page, 'vidno-warnock'))).toEqual(new Set([thing]));
    expect(await violations(page)).toEqual([]);
    await page.mouse.move(5, 5);
    await expect.poll(() => halo(page)).toBe(0);
    expect(faults).toEqual([]);
  });

  it('in the picture, by its name or its outline, lights up in the list', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await goTo(page, 200);
    await pointAt(page, 'vidno-picture .label[data-thing="polygon A"]');
    await expect.poll(() => lit(page, 'vidno-warnock .apl')).toContain('polygon A');
  });
});

describe('each row of the state', () => {
  it('is linked to its place: a window of the stack, a corner, an edge', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await goTo(page, 400);
    for (const row of ['.stack tr', '.corners td']) {
      await page.locator(`vidno-warnock ${row}`).first().hover();
      await expect.poll(() => halo(page), { message: row }).toBe(1);
    }
  });

  it('of AEL is linked to its edge', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'zbuffer.jsonl', sampleTrace('small.zbuffer.signs'));
    const added = sampleTrace('small.zbuffer.signs')
      .split('\n')
      .findIndex((line) => line.includes('"e":"ael_add"'));
    await goTo(page, added);
    await page.locator('vidno-zbuffer .ael tbody tr').first().hover();
    await expect.poll(() => halo(page)).toBe(1);
  });

  it('is reached by keyboard, and announced', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('o');
    const said = page.locator('vidno-player .pointed-at');
    await expect.poll(() => said.textContent()).toBe('Polygon A');
    await expect.poll(() => halo(page)).toBe(1);
    await page.keyboard.press('Shift+O');
    await expect.poll(() => halo(page)).toBe(0);
    expect(await said.textContent()).toBe('');
  });
});
