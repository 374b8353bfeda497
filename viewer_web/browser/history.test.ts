import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { looks, spotOf } from './live.js';
import {
  goTo,
  lessonTraces,
  open,
  openLesson,
  opened,
  placesOf,
  sampleTrace,
  shown,
  small,
  widthOf,
} from './page.js';

async function click(page: Page, x: number, y: number): Promise<void> {
  const spot = await spotOf(page, x + 0.5, y + 0.5);
  await page.mouse.click(spot.x, spot.y);
  await page.locator('vidno-history .entries').waitFor();
}

const stepsIn = (page: Page): Promise<readonly number[]> =>
  page
    .locator('vidno-history .entries li')
    .evaluateAll((items) => items.map((item) => Number((item as HTMLElement).dataset['step'])));

/** Whether the entry of a step is scrolled into view in its list. */
const inSight = (page: Page, step: number): Promise<boolean> =>
  page.locator(`vidno-history .entries li[data-step="${step}"]`).evaluate((item) => {
    const box = item.closest('.entries')?.getBoundingClientRect();
    const { top, bottom } = item.getBoundingClientRect();
    return box !== undefined && top >= box.top && bottom <= box.bottom + 1;
  });

describe('the history of a pixel', () => {
  it('is opened by a click, with the reason for its colour in sight', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'zbuffer.jsonl', sampleTrace('small.zbuffer.signs'));
    await click(page, 4, 0);
    expect(await stepsIn(page)).toEqual([3, 32, 33, 36, 39, 89, 90, 92, 94]);
    expect(await page.locator('vidno-history .why').textContent()).toContain('B is nearer here');
    expect(await inSight(page, 94)).toBe(true);
    expect(await looks(page, 'chosen')).toBe(2); // with its casing
    await page.keyboard.press('ArrowRight');
    expect((await shown(page)).step).toBe(1); // the click did not take the keyboard
    expect(faults).toEqual([]);
  });

  it('goes to its steps, and follows them', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await click(page, 4, 0);
    const steps = await stepsIn(page);
    const entry = page.locator('vidno-history .entries li button');
    await entry.nth(5).click();
    expect((await shown(page)).step).toBe(steps[5]);
    for (const step of [steps[20], steps[60], steps[2], steps.at(-1)]) {
      await goTo(page, step ?? 0);
      const now = page.locator('vidno-history .entries li.now');
      expect(await now.getAttribute('data-step')).toBe(String(step));
      expect(await now.locator('[aria-current=step]').count()).toBe(1);
      expect(await inSight(page, step ?? 0)).toBe(true);
    }
  });

  it('is chosen and walked through by keyboard alone', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'zbuffer.jsonl', sampleTrace('small.zbuffer.signs'));
    await page.keyboard.press('p'); // in the middle, (4, 1)
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Enter');
    expect(await page.locator('vidno-side button[aria-pressed=true]').textContent()).toContain(
      'Pixel (5, 0)',
    );
    expect((await shown(page)).step).toBe(0);
    await page.keyboard.press('Escape');
    await page.keyboard.press('ArrowRight');
    expect((await shown(page)).step).toBe(1);
    await page.locator('vidno-history .last').focus();
    await page.keyboard.press('Enter');
    expect((await shown(page)).step).toBe(94);
    await page.locator('vidno-history .entries li button[tabindex="0"]').focus();
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Enter');
    expect((await shown(page)).step).toBe(93);
    await page.locator('vidno-history .forget').focus();
    await page.keyboard.press('Enter');
    await page.locator('vidno-zbuffer').waitFor();
    expect(await looks(page, 'chosen')).toBe(0);
    expect(faults).toEqual([]);
  });

  it('is kept in the address', async () => {
    const { page: first } = await open(browser, '#lang=en');
    const last = (await lessonTraces(first)).filter((trace) => trace.includes('.zbuffer.')).at(-1);
    if (last === undefined) return;
    await openLesson(first, last);
    const box = await first.locator('vidno-picture').boundingBox();
    if (box === null) throw new Error('no picture');
    await first.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await first.waitForFunction(() => location.hash.includes('pixel='));
    const name = await first.locator('vidno-side button[aria-pressed=true]').textContent();
    const { page } = await open(browser, new URL(first.url()).hash);
    await page.locator('vidno-history .entries').waitFor();
    expect(await page.locator('vidno-side button[aria-pressed=true]').textContent()).toBe(name);
  });
});

describe('with the history of a pixel', () => {
  it('the page is accessible', async () => {
    for (const [name, text] of [
      ['small.jsonl', small],
      ['zbuffer.jsonl', sampleTrace('small.zbuffer.signs')],
    ] as const) {
      const { page } = await open(browser, '#lang=ru');
      await opened(page, name, text);
      await click(page, 4, 0);
      await goTo(page, 60);
      await page.keyboard.press('Tab');
      expect(await violations(page)).toEqual([]);
    }
  });

  it('nothing is clipped or moves at any width', async () => {
    const { page } = await open(browser, '#lang=ru');
    await opened(page, 'small.jsonl', small);
    await click(page, 4, 0);
    for (const width of [390, 768, 1280, 1920]) {
      await page.setViewportSize({ width, height: width < 500 ? 844 : 1080 });
      const places = new Set<string>();
      for (const step of [0, 1, 60, 900, 1400]) {
        await goTo(page, step);
        places.add(
          await placesOf(page, 'vidno-history .head, vidno-history .entries, .dock, .listing'),
        );
        expect(await widthOf(page)).toBe(width);
        const wide = await page
          .locator('vidno-history .entries')
          .evaluate((list) => list.scrollWidth - list.clientWidth);
        expect(wide, `at ${width} px`).toBe(0);
      }
      expect([...places], `at ${width} px`).toHaveLength(1);
    }
  });

  it('every target is large enough', async () => {
    const { page } = await open(browser, '#lang=en', { viewport: { width: 390, height: 844 } });
    await opened(page, 'small.jsonl', small);
    await click(page, 4, 0);
    const sizes = await page
      .locator('vidno-side button')
      .evaluateAll((all) =>
        all.map((each) => each.getBoundingClientRect()).map((r) => [r.width, r.height]),
      );
    for (const [width = 0, height = 0] of sizes)
      expect(Math.min(width, height)).toBeGreaterThan(24);
  });
});
