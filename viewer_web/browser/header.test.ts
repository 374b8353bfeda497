import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { openReader } from './reader.js';

/** Adds a link and its place, as another language would. */
async function addLanguage(page: Page): Promise<void> {
  await page.locator('vidno-languages a').evaluate((link) => {
    const another = link.cloneNode(true) as Element;
    another.textContent = 'Português';
    link.after(another);
  });
  await page.locator('vidno-app').evaluate((app: HTMLElement) => {
    app.style.setProperty('--languages', '2');
  });
}

/** The pairs of visible controls at the top of the page that overlap, and the controls beyond the right edge of the window. */
function faults(page: Page): Promise<readonly string[]> {
  const controls = page.locator(
    ':is(vidno-page-header :is(h1, button:not(.skip)), vidno-languages a):visible',
  );
  return controls.evaluateAll((all) => {
    const words = (e: Element): string => e.textContent.trim().slice(0, 12);
    const boxes = all.map((e) => ({ e, box: e.getBoundingClientRect() }));
    const beyond = boxes.filter(({ box }) => box.right > innerWidth);
    const pairs = boxes.flatMap((one, place) =>
      boxes
        .slice(place + 1)
        .filter(({ box }) => one.box.left < box.right && box.left < one.box.right)
        .filter(({ box }) => one.box.top < box.bottom && box.top < one.box.bottom)
        .map((other) => `${words(one.e)} / ${words(other.e)}`),
    );
    return [...beyond.map(({ e }) => `${words(e)} is cut off`), ...pairs];
  });
}

describe('The line at the top of the page', () => {
  it.each(['en', 'ru'])('has room for a third language (%s)', async (language) => {
    const { page } = await openReader(browser, `#lang=${language}`);
    await addLanguage(page);
    for (const width of [1440, 1280, 1199, 900, 899, 390, 320]) {
      await page.setViewportSize({ width, height: 800 });
      expect(await faults(page), `${width} pixels`).toEqual([]);
    }
  });
});
