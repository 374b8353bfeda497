import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { goTo, open, opened, sampleTrace, shown, small } from './page.js';

const stepOf = async (page: Page): Promise<number> => (await shown(page)).step;

async function press(page: Page, key: string): Promise<number> {
  await page.keyboard.press(key);
  return stepOf(page);
}

async function click(page: Page, label: string): Promise<number> {
  await page.locator('vidno-travel').getByRole('button', { name: label, exact: true }).click();
  return stepOf(page);
}

describe('stepping through procedures', () => {
  it('goes over and out, forward and back, by mouse', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'inside.jsonl', sampleTrace('inside.warnock.signs'));
    await goTo(page, 3);
    expect(await click(page, 'Over the call')).toBe(23);
    expect(await click(page, 'Back over the call')).toBe(3);
    await goTo(page, 19);
    expect(await click(page, 'Out of the procedure, to its result')).toBe(21);
    expect(await click(page, 'Back over the call')).toBe(17);
    expect(await click(page, 'Back out of the procedure, before its call')).toBe(3);
    expect(faults).toEqual([]);
  });

  it('does so by keyboard', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'inside.jsonl', sampleTrace('inside.warnock.signs'));
    for (const key of [']', ']', ']', ']']) await page.keyboard.press(key);
    expect(await stepOf(page)).toBe(23);
    expect(await press(page, '[')).toBe(3);
    await page.keyboard.press('ArrowRight');
    expect(await press(page, 'Shift+]')).toBe(23);
    await page.keyboard.press('ArrowLeft');
    expect(await press(page, 'Shift+[')).toBe(3);
  });
});

describe('the controls go to the next', () => {
  it('split of a window, by keyboard and mouse', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', sampleTrace('small.warnock.windows'));
    expect([await press(page, '.'), await press(page, '.'), await press(page, '.')]).toEqual([
      3, 9, 15,
    ]);
    expect(await press(page, ',')).toBe(9);
    expect(await click(page, 'The next one')).toBe(15);
    expect(await click(page, 'The previous one')).toBe(9);
    expect(await page.locator('vidno-travel .count').textContent()).toBe('2 / 9');
  });

  it('change of AEL, step of a polygon and of the chosen pixel', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'zbuffer.jsonl', sampleTrace('small.zbuffer.signs'));
    expect([await press(page, '.'), await press(page, '.'), await press(page, '.')]).toEqual([
      15, 16, 73,
    ]);
    await page.locator('vidno-travel select').selectOption('polygon B');
    await page.locator('vidno-travel select').blur();
    expect(await press(page, '.')).toBe(74);
    await page.locator('vidno-travel select').selectOption('pixel');
    await page.locator('vidno-travel select').blur();
    expect(await press(page, '.')).toBe(74); // no pixel is chosen yet
    await page.keyboard.press('p');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Enter');
    await page.keyboard.press('Escape'); // (4, 0)
    expect([await press(page, '.'), await press(page, '.'), await press(page, ',')]).toEqual([
      89, 90, 89,
    ]);
  });

  it('wrong decision of a checked trace', async () => {
    const { page } = await open(browser, '#lang=en');
    const lines = sampleTrace('small.zbuffer.signs').trim().split('\n');
    const wrong =
      '{"e":"disagree","at":"L6","of":"nearer","taken":true,"exact":false,"cause":"rounded"}';
    lines.splice(37, 0, wrong); // after the pixel of step 36
    const text = [...lines.slice(0, -1), lines.at(-1)?.replace('110', '111'), ''].join('\n');
    await opened(page, 'checked.jsonl', text);
    await page.locator('vidno-travel select').selectOption('wrong');
    expect(await click(page, 'The next one')).toBe(37);
    expect((await shown(page)).sentence).toContain('Decided wrongly');
    await page.keyboard.press('End');
    expect(await press(page, ',')).toBe(37);
  });
});

describe('the row of these controls', () => {
  it.each([390, 768, 1280, 1920])('is not clipped at %i px, with large targets', async (width) => {
    const viewport = { width, height: width < 500 ? 844 : 1080 };
    for (const language of ['en', 'ru']) {
      const { page } = await open(browser, `#lang=${language}`, { viewport });
      await opened(page, 'small.jsonl', small);
      const boxes = await page
        .locator('vidno-travel :is(button, select)')
        .evaluateAll((all) => all.map((each) => each.getBoundingClientRect().toJSON() as DOMRect));
      for (const box of boxes) {
        expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(24);
        expect(box.x).toBeGreaterThanOrEqual(0);
        expect(box.right).toBeLessThanOrEqual(width);
      }
    }
  });

  it('is accessible', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'zbuffer.jsonl', sampleTrace('small.zbuffer.signs'));
    await page.keyboard.press('?');
    expect(await violations(page)).toEqual([]);
  });
});
