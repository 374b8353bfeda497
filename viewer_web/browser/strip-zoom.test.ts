import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import * as fromPage from './page.js';
import { goTo, open, sampleTrace, shown, small } from './page.js';
import { press } from './predict.js';
import { title } from './live.js';

// 115 events: a tenth of the strip is 11.5 steps.
const windows = sampleTrace('small.warnock.windows');

async function opened(page: Page, name: string, content: string): Promise<void> {
  await fromPage.opened(page, name, content);
  const isDrawn = (): Promise<boolean> =>
    page
      .locator('.strip vidno-strip')
      .evaluate((strip) => 'course' in strip && strip.course !== null);
  await expect.poll(isDrawn, { timeout: 60_000 }).toBe(true);
}

const overview = 'vidno-overview .bar';
const strip = 'vidno-slider .strip';
/** The range of steps in the strip's label, before the current step. */
const said = async (page: Page): Promise<string | undefined> =>
  (await page.locator(strip).getAttribute('aria-valuetext'))?.split('; ')[0];
const news = (page: Page): Promise<string | null> =>
  page.locator('vidno-slider [role=status]').textContent();
const wayBack = (page: Page) => page.locator('vidno-slider .whole');
const stepOf = async (page: Page): Promise<number> => (await shown(page)).step;

/** Drags along a bar from one fraction of its length to another. */
async function drag(page: Page, bar: string, from: number, to: number): Promise<void> {
  const box = await page.locator(bar).boundingBox();
  if (box === null) throw new Error(`no ${bar}`);
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + from * box.width, y);
  await page.mouse.down();
  await page.mouse.move(box.x + ((from + to) / 2) * box.width, y);
  await page.mouse.move(box.x + to * box.width, y);
  await page.mouse.up();
}

async function ready(hash = '#lang=en'): Promise<Page> {
  const { page } = await open(browser, hash);
  await opened(page, 'windows.jsonl', windows);
  return page;
}

describe('the strip', () => {
  it('shows the part that is drawn on the overview, and a click in it goes to a step there', async () => {
    const page = await ready();
    expect(await said(page)).toBe('The whole run');
    expect(await wayBack(page).count()).toBe(0);
    await drag(page, overview, 0.4, 0.8);
    expect(await said(page)).toBe('Steps 46 to 92 of 115'); // 0.4 and 0.8 of 115
    expect(await news(page)).toBe('Steps 46 to 92 of 115');
    const strip = await page.locator('vidno-slider .strip').boundingBox();
    if (strip === null) throw new Error('no strip');
    await page.mouse.click(strip.x + strip.width / 2, strip.y + strip.height / 2);
    expect(await stepOf(page)).toBe(69); // in the middle of 46 and 92
    await wayBack(page).click();
    expect(await said(page)).toBe('The whole run');
    expect(await wayBack(page).count()).toBe(0);
  });

  it('follows the part as it is moved on the overview, and dragged by an end', async () => {
    const page = await ready();
    await drag(page, overview, 0.4, 0.8);
    await drag(page, overview, 0.6, 0.5);
    expect(await said(page)).toBe('Steps 35 to 81 of 115'); // from step 69 to 58, which is the one nearest to 57.5
    await drag(page, overview, 81 / 115, 1);
    expect(await said(page)).toBe('Steps 35 to 115 of 115');
  });

  it('is zoomed by wheel around the step under the pointer', async () => {
    const page = await ready();
    const strip = await page.locator('vidno-slider .strip').boundingBox();
    if (strip === null) throw new Error('no strip');
    const tip = page.locator('vidno-slider .tip');
    await page.mouse.move(strip.x + 0.3 * strip.width, strip.y + 30);
    const before = await tip.textContent();
    expect(before).toMatch(/^Step 35 of 115/); // 34.5
    await page.mouse.wheel(0, -300);
    expect(await said(page)).toBe('Steps 17 to 75 of 115'); // 57.5 steps, 0.3 of them before 34.5: from 17.25 on
    await page.mouse.move(strip.x + 0.3 * strip.width + 1, strip.y + 30);
    expect(await tip.textContent()).toMatch(/^Step 3[45] of 115/);
    await page.mouse.wheel(0, 300);
    expect(await said(page)).toBe('The whole run');
  });

  it('is zoomed and moved by two fingers, which do not seek', async () => {
    const { page } = await open(browser, '#lang=en', { hasTouch: true });
    await opened(page, 'windows.jsonl', windows);
    const strip = await page.locator('vidno-slider .strip').boundingBox();
    if (strip === null) throw new Error('no strip');
    const session = await page.context().newCDPSession(page);
    const touch = (type: string, ...places: readonly number[]): Promise<unknown> =>
      session.send('Input.dispatchTouchEvent', {
        type: type as 'touchStart',
        touchPoints: places.map((place, id) => ({
          x: strip.x + place * strip.width,
          y: strip.y + 30,
          id,
        })),
      });
    await touch('touchStart', 0.4);
    expect(await stepOf(page)).toBe(46);
    await touch('touchStart', 0.4, 0.6);
    await touch('touchMove', 0.3, 0.6);
    await touch('touchMove', 0.3, 0.7);
    await touch('touchEnd');
    expect(await stepOf(page)).toBe(46);
    // The fingers were at steps 46 and 69. They are now 0.4 of the strip apart, so it shows 57.5 steps, 0.3 of them before
    // 46.
    await expect.poll(() => said(page)).toMatch(/^Steps (28|29) to (86|87) of 115$/);
  });

  it('is zoomed by keyboard, names its range, and is stepped through as before', async () => {
    const page = await ready();
    await goTo(page, 23); // a fifth of 115
    await page.locator('.slider').focus();
    await press(page, 'Tab', 'Tab');
    await press(page, '+');
    expect(await said(page)).toBe('Steps 12 to 69 of 115'); // 57.5, of which a fifth lies before 23: from 11.5 on
    await press(page, '+');
    expect(await said(page)).toBe('Steps 17 to 46 of 115'); // 28.75 from 17.25 on
    await press(page, 'Shift+PageUp');
    expect(await said(page)).toBe('Steps 43 to 72 of 115'); // 0.9 of 28.75 later: from 43.125 to 71.875
    await press(page, 'Shift+PageDown', '-');
    expect(await said(page)).toBe('Steps 12 to 69 of 115');
    expect(await page.locator(strip).getAttribute('aria-valuetext')).toBe(
      'Steps 12 to 69 of 115; Step 23 of 115: window 1 × 1 at (6, 1), pixel',
    );
    await press(page, 'Escape');
    expect(await said(page)).toBe('The whole run');
    await press(page, '+', '0');
    expect(await said(page)).toBe('The whole run');
    await press(page, 'ArrowRight');
    expect(await stepOf(page)).toBe(24);
  });

  it('follows a step that leaves its range, and is not repainted until one does', async () => {
    const page = await ready();
    await drag(page, overview, 0.4, 0.8);
    await goTo(page, 92);
    const isStained = (stain: boolean): Promise<boolean> =>
      page.locator('.strip vidno-strip canvas').evaluate((canvas: HTMLCanvasElement, paint) => {
        const context = canvas.getContext('2d');
        if (context === null) return false;
        context.fillStyle = '#00ff00';
        if (paint) context.fillRect(9, 0, 1, 1);
        return context.getImageData(9, 0, 1, 1).data.join() === '0,255,0,255';
      }, stain);
    await isStained(true);
    await page.locator(title).click();
    await press(page, 'ArrowLeft', 'ArrowRight');
    expect(await said(page)).toBe('Steps 46 to 92 of 115');
    expect(await isStained(false)).toBe(true);
    await press(page, 'ArrowRight');
    expect(await stepOf(page)).toBe(93);
    expect(await said(page)).toBe('Steps 69 to 115 of 115'); // a tenth before the step would extend beyond the end
    await expect.poll(() => isStained(false)).toBe(false);
    await press(page, 'Home');
    expect(await said(page)).toBe('Steps 0 to 46 of 115');
  });

  it('keeps its range when the reader returns to a run', async () => {
    const page = await ready();
    await drag(page, overview, 0.4, 0.8);
    await opened(page, 'small.jsonl', small);
    expect(await said(page)).toBe('The whole run');
    await opened(page, 'windows.jsonl', windows);
    expect(await said(page)).toBe('Steps 46 to 92 of 115');
  });

  it('can be used by all while zoomed', async () => {
    const viewport = { width: 1280, height: 1080 };
    const { page } = await open(browser, '#lang=ru', { viewport });
    await opened(page, 'windows.jsonl', windows);
    await drag(page, overview, 0.4, 0.8);
    expect(await said(page)).toBe('Шаги с 46 по 92 из 115');
    expect(await violations(page)).toEqual([]);
  });
});
