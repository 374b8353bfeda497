import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { openReader } from './reader.js';
import type { Page } from 'playwright-core';

const meaning = "A rectangle of the screen that Warnock's algorithm decides or splits as a whole.";
const inText = (page: Page) =>
  page.locator('vidno-reader vidno-term').filter({ hasText: 'window' });
const popover = (page: Page) => page.locator('vidno-term [popover]:popover-open');

describe('a term of the glossary', () => {
  it('is marked once in each section of a text, and not in headings and links', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    // Three sections of the sample have the passage about windows: the beginning and those of the two headings of level 2.
    expect(await inText(page).count()).toBe(3);
    expect(await page.locator('vidno-reader :is(a, h2, h3, h4) vidno-term').count()).toBe(0);
  });

  it('shows its meaning by a click, and hides it by Escape, within the screen', async () => {
    for (const width of [390, 1440]) {
      const { page, faults } = await openReader(browser, '#lang=en&lesson=first', {
        viewport: { width, height: 800 },
      });
      await inText(page).first().click();
      await expect.poll(() => popover(page).textContent()).toContain(meaning);
      const box = await popover(page).boundingBox();
      expect(box?.x).toBeGreaterThanOrEqual(0);
      expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(width);
      await page.keyboard.press('Escape');
      await expect.poll(() => popover(page).count()).toBe(0);
      expect(faults).toEqual([]);
    }
  });

  it.each(['Enter', 'Space'])('shows its meaning by %s, and does not play the run', async (key) => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    await inText(page).first().locator('button').focus();
    await page.keyboard.press(key);
    await expect.poll(() => popover(page).textContent()).toContain(meaning);
    expect(await violations(page)).toEqual([]);
  });

  it('shows its meaning by touch, in Russian too', async () => {
    const { page } = await openReader(browser, '#lang=ru&lesson=first', { hasTouch: true });
    await page.locator('vidno-reader vidno-term').filter({ hasText: 'окн' }).first().tap();
    await expect.poll(() => popover(page).textContent()).toContain('Прямоугольник экрана');
  });

  it('shows its meaning in the sentence of a step', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&step=5');
    await page.locator('vidno-player .sentence vidno-term').first().click();
    await expect.poll(() => popover(page).count()).toBe(1);
  });
});
