import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import * as fromPage from './page.js';
import { goTo, open, sampleTrace, shown, small } from './page.js';

const windows = sampleTrace('small.warnock.windows');

/** Opens a trace and waits until the strip shows all of it. The strip is drawn after the picture. */
async function opened(page: Page, name: string, content: string): Promise<void> {
  await fromPage.opened(page, name, content);
  const isDrawn = (): Promise<boolean> =>
    page
      .locator('.strip vidno-strip')
      .evaluate((strip) => 'course' in strip && strip.course !== null);
  await expect.poll(isDrawn, { timeout: 60_000 }).toBe(true);
}
const stepOf = async (page: Page): Promise<number> => (await shown(page)).step;
const said = (page: Page): Promise<string | null> =>
  page.locator('.slider').getAttribute('aria-valuetext');

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

async function boxOf(page: Page, selector: string): Promise<Box> {
  const box = await page.locator(selector).boundingBox();
  if (box === null) throw new Error(`no ${selector}`);
  return box;
}

/** A Z-buffer run of `length` events, one of which is a wrong decision. */
function withOneWrong(length: number, step: number): string {
  const [header = '', clear = '', polygon = ''] = sampleTrace('small.zbuffer.windows').split('\n');
  const lines = Array<string>(length).fill('{"e":"scanline","at":"Z6","y":0.5,"row":0}');
  [lines[0], lines[1]] = [clear, polygon];
  lines[step - 1] =
    '{"e":"disagree","at":"Z6","of":"rows","taken":[0,7],"exact":[0,8],"cause":"rounded"}';
  const end = { end: { events: length, picture: `sha256:${'0'.repeat(64)}` } };
  return [header, ...lines, JSON.stringify(end), ''].join('\n');
}

/** The colours of a column of the strip, as "r,g,b,a". */
const columnAt = (page: Page, x: number): Promise<readonly string[]> =>
  page.locator('.strip vidno-strip canvas').evaluate((canvas: HTMLCanvasElement, at) => {
    const data = canvas.getContext('2d')?.getImageData(at, 0, 1, canvas.height).data ?? [];
    return Array.from({ length: canvas.height }, (_, y) =>
      [...data.slice(4 * y, 4 * y + 4)].join(),
    );
  }, x);

describe('the strip', () => {
  it('is aligned with the slider to the pixel: a click on either goes to the same step', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    const strip = await boxOf(page, 'vidno-slider .strip');
    const slider = await boxOf(page, '.slider');
    for (const part of [0, 0.013, 0.25, 0.5, 0.777, 1]) {
      const x = strip.x + part * (strip.width - 1);
      await page.mouse.click(x, strip.y + strip.height / 2);
      const step = await stepOf(page);
      await page.mouse.click(x, slider.y + slider.height / 2);
      expect(Math.abs((await stepOf(page)) - step)).toBeLessThanOrEqual(1); // half a pixel is a step
    }
    expect(faults).toEqual([]);
  });

  it('seeks while the mouse is dragged along it', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'windows.jsonl', windows);
    const { x, y, width, height } = await boxOf(page, 'vidno-slider .strip');
    await page.mouse.move(x + width / 4, y + height / 2);
    await page.mouse.down();
    expect(await stepOf(page)).toBe(29); // 115 / 4 = 28.75
    await page.mouse.move(x + width / 2 + 1, y + height / 2);
    expect(await stepOf(page)).toBe(58); // 115 / 2 = 57.5, and a pixel
    await page.mouse.up();
    await page.mouse.move(x, y);
    expect(await stepOf(page)).toBe(58);
  });

  it('describes the step under the mouse, until Escape', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'windows.jsonl', windows);
    const { x, y, width, height } = await boxOf(page, 'vidno-slider .strip');
    const tip = page.locator('vidno-slider .tip');
    await page.mouse.move(x + (22 / 115) * width, y + height / 2);
    expect(await tip.textContent()).toBe('Step 22 of 115: window 1 × 1 at (6, 2), pixel');
    await page.keyboard.press('Escape');
    expect(await tip.count()).toBe(0);
    await page.locator('vidno-languages [lang=ru]').click();
    await page.mouse.move(x + (3 / 115) * width, y + height / 2);
    expect(await tip.textContent()).toBe('Шаг 3 из 115: окно 8 × 8 в (2; −1), делится');
    await page.mouse.move(x, y - 200);
    expect(await tip.count()).toBe(0);
    expect(await stepOf(page)).toBe(0);
  });

  it('keeps one wrong decision visible among 60 000 steps, and a click near it goes there', async () => {
    const { page } = await open(browser, '#lang=en', { colorScheme: 'light' });
    await opened(page, 'long.jsonl', withOneWrong(60_000, 30_007));
    const { x, y, width, height } = await boxOf(page, 'vidno-slider .strip');
    const at = Math.floor(((30_007 + 0.5) / 60_000) * width);
    const red = '163,18,43,255';
    expect((await columnAt(page, at)).slice(0, 6)).toContain(red);
    expect((await columnAt(page, at - 8)).slice(0, 6)).not.toContain(red);
    await page.mouse.click(x + at + 2, y + height / 2);
    expect(await stepOf(page)).toBe(30_007);
    expect(await said(page)).toBe('Step 30007 of 60000: polygon A, row 0, wrong decision');
  });

  it('is repainted for another size and theme, but not for another step', async () => {
    const { page } = await open(browser, '#lang=en', { colorScheme: 'light' });
    await opened(page, 'windows.jsonl', windows);
    const stain = (): Promise<void> =>
      page.locator('.strip vidno-strip canvas').evaluate((canvas: HTMLCanvasElement) => {
        const context = canvas.getContext('2d');
        if (context === null) return;
        context.fillStyle = '#00ff00';
        context.fillRect(9, 0, 1, 1);
      });
    const isStained = async (): Promise<boolean> => (await columnAt(page, 9))[0] === '0,255,0,255';
    await stain();
    for (const key of ['ArrowRight', 'End', 'Home']) await page.keyboard.press(key);
    await shown(page);
    expect(await isStained()).toBe(true);
    await page.emulateMedia({ colorScheme: 'dark' });
    await expect.poll(isStained).toBe(false);
    await stain();
    await page.setViewportSize({ width: 1100, height: 800 });
    await expect.poll(isStained).toBe(false);
  });

  it.each([1, 1.5, 2])('has one canvas pixel per device pixel (ratio %d)', async (ratio) => {
    const { page } = await open(browser, '#lang=en', { deviceScaleFactor: ratio });
    await opened(page, 'windows.jsonl', windows);
    const dots = (): Promise<number> =>
      page
        .locator('.strip vidno-strip canvas')
        .evaluate((canvas: HTMLCanvasElement) => canvas.width / canvas.clientWidth);
    await expect.poll(async () => Math.abs((await dots()) - ratio)).toBeLessThan(0.005);
  });
});

describe('the slider', () => {
  it('states its position, and has keys of its own', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'windows.jsonl', windows);
    expect(await said(page)).toBe('Step 0 of 115');
    await goTo(page, 21);
    await page.locator('.slider').focus();
    await page.keyboard.press('ArrowRight');
    expect(await stepOf(page)).toBe(22);
    expect(await said(page)).toBe('Step 22 of 115: window 1 × 1 at (6, 2), pixel');
    await opened(page, 'zbuffer.jsonl', sampleTrace('small.zbuffer.windows'));
    await goTo(page, 15);
    expect(await said(page)).toBe('Step 15 of 19: polygon B, row 0');
  });
});

describe('the legend of the strip', () => {
  it('is opened and closed by keyboard, and lists only what the trace contains', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    const card = page.locator('vidno-strip-legend section');
    await page.locator('.slider').focus();
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    expect(await card.isVisible()).toBe(true);
    expect(await card.locator('li').allTextContents()).toContain('surrounded');
    await page.keyboard.press('Escape');
    expect(await card.isVisible()).toBe(false);
    await opened(page, 'zbuffer.jsonl', sampleTrace('small.zbuffer.windows'));
    await page.locator('vidno-strip-legend button').click();
    const entries = await card.locator('li').allTextContents();
    expect(entries.join()).toContain('polygon');
    expect(entries.join()).not.toMatch(/surrounded|AEL|calls/); // not told at this level
  });

  const sizes = [390, 1280, 1920].flatMap((width) =>
    (['en', 'ru'] as const).map((language) => ({ width, language })),
  );
  it.each(sizes)('is not clipped at $width px in $language', async ({ width, language }) => {
    const viewport = { width, height: width < 500 ? 844 : 1080 };
    const { page } = await open(browser, `#lang=${language}`, { viewport });
    await opened(page, 'small.jsonl', small);
    await page.locator('vidno-strip-legend button').click();
    const { x, y, width: wide } = await boxOf(page, 'vidno-strip-legend section');
    expect(x).toBeGreaterThanOrEqual(0);
    expect(y).toBeGreaterThanOrEqual(0);
    expect(x + wide).toBeLessThanOrEqual(width);
  });

  it.each([390, 1280, 1920])('and the strip is accessible (%s px)', async (width) => {
    const viewport = { width, height: width < 500 ? 844 : 1080 };
    const { page } = await open(browser, '#lang=en', { viewport });
    await opened(page, 'small.jsonl', small);
    await page.locator('vidno-strip-legend button').click();
    expect(await violations(page)).toEqual([]);
  });
});
