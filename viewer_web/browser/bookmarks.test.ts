import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { bookmark, listed } from './bookmarks.js';
import { browser } from './browser.js';
import { goTo, open, opened, shown, small } from './page.js';

const stepOf = async (page: Page): Promise<number> => (await shown(page)).step;

describe('bookmarks', () => {
  it('are set, visited, edited and removed by keyboard alone', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
    await page.keyboard.press('b');
    await page.locator('textarea:focus').waitFor();
    await page.keyboard.type('b? a note, of 3 steps +');
    await page.keyboard.press('Enter');
    expect(await stepOf(page)).toBe(3); // no key is a command inside a note
    expect(await page.locator('vidno-keys dialog').isVisible()).toBe(false);
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('b');
    await page.locator('textarea[data-note="13"]:focus').waitFor();
    await page.keyboard.press('Enter');
    expect(await listed(page)).toEqual([
      [3, 'b? a note, of 3 steps +'],
      [13, ''],
    ]);
    await page.keyboard.press('End');
    await page.keyboard.press('Shift+Comma');
    expect(await stepOf(page)).toBe(13);
    await page.keyboard.press('Shift+Comma');
    expect(await stepOf(page)).toBe(3);
    await page.keyboard.press('Shift+Comma');
    expect(await stepOf(page)).toBe(3);
    await page.keyboard.press('Shift+Period');
    expect(await stepOf(page)).toBe(13);

    await page.keyboard.press('b'); // a bookmark exists: the key opens its note
    await page.locator('textarea[data-note="13"]:focus').waitFor();
    await page.keyboard.type('second');
    await page.keyboard.press('Enter');
    await page.keyboard.press('b');
    await page.locator('textarea[data-note="13"]:focus').waitFor();
    await page.keyboard.type(' no');
    await page.keyboard.press('Escape');
    expect((await listed(page))[1]).toEqual([13, 'second']);

    await page.keyboard.press('Home');
    await page.keyboard.press('Shift+B');
    await page.locator('[data-go="3"]:focus').waitFor();
    await page.keyboard.press('Enter');
    expect(await stepOf(page)).toBe(3);
    for (const key of ['Tab', 'Tab', 'Enter']) await page.keyboard.press(key);
    expect(await listed(page)).toEqual([[13, 'second']]);
    expect(faults).toEqual([]);
  });

  it('and by mouse', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await goTo(page, 60);
    await page.getByRole('button', { name: 'Bookmarks: 0' }).click();
    await page.getByRole('button', { name: 'Bookmark step 60' }).click();
    await page.getByRole('textbox', { name: 'Note of step 60' }).fill('here');
    await goTo(page, 5);
    await page.getByRole('button', { name: 'Bookmark step 5' }).click();
    expect(await listed(page)).toEqual([
      [5, ''],
      [60, 'here'],
    ]);
    await page.getByRole('button', { name: 'Go to step 60' }).click();
    expect(await stepOf(page)).toBe(60);
    await page.locator('vidno-travel select').selectOption('bookmark');
    await page.locator('vidno-travel').getByRole('button', { name: 'The previous one' }).click();
    expect(await stepOf(page)).toBe(5);
    await page.getByRole('button', { name: 'Remove the bookmark of step 60' }).click();
    expect(await listed(page)).toEqual([[5, '']]);
    expect(faults).toEqual([]);
  });

  it('are marked on the strip with their notes, and a click near one goes to it', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await bookmark(page, 900, 'look');
    await bookmark(page, 100, '');
    await goTo(page, 1);
    expect(await page.locator('vidno-slider .flag').count()).toBe(2);
    const strip = await page.locator('vidno-slider .strip').boundingBox();
    if (strip === null) throw new Error('no strip');
    const x = strip.x + (900 / 1545) * strip.width + 2;
    await page.mouse.move(x, strip.y + 4);
    expect(await page.locator('vidno-slider .tip').textContent()).toMatch(
      /^Step 900 of 1545: window .*, bookmark “look”$/,
    );
    await page.mouse.click(x, strip.y + 4);
    expect(await stepOf(page)).toBe(900);
    expect(await page.locator('.slider').getAttribute('aria-valuetext')).toMatch(/“look”$/);
  });

  it('are reported to the page that embeds the player', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await page.evaluate(() => {
      const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
      const told: unknown[] = [];
      Object.assign(window, { told });
      player?.addEventListener('vidno-bookmarks', (event) =>
        told.push((event as CustomEvent).detail),
      );
    });
    await bookmark(page, 7, 'x');
    expect(await page.evaluate(() => (window as unknown as { told: unknown }).told)).toEqual([
      [{ step: 7, note: '' }],
      [{ step: 7, note: 'x' }],
    ]);
  });
});

describe('the limits of bookmarks', () => {
  it('are explained in words', async () => {
    const { page } = await open(browser, '#lang=ru');
    await opened(page, 'small.jsonl', small);
    const word = page.locator('vidno-bookmarks .limit');
    for (let step = 1; step <= 16; step++) {
      await page.keyboard.press('ArrowRight');
      await page.keyboard.press('b');
      await page.locator(`textarea[data-note="${step}"]:focus`).waitFor();
      await page.keyboard.press('Enter');
    }
    expect(await word.textContent()).toBe('');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('b');
    await word.getByText('Закладок уже 16').waitFor();
    expect(await listed(page)).toHaveLength(16);
    await page.locator('textarea').first().fill('я'.repeat(59));
    expect(await word.textContent()).toBe('');
    await page.locator('textarea').first().focus();
    await page.keyboard.press('End');
    await page.keyboard.type('яя');
    expect(await word.textContent()).toBe('В заметке не более 60 знаков.');
    await page.keyboard.press('Enter');
    expect((await listed(page))[0]).toEqual([1, 'я'.repeat(60)]);
  });
});

describe('the list of bookmarks', () => {
  it.each([390, 1280, 1920])('can be used by all (%s px)', async (width) => {
    const viewport = { width, height: width < 500 ? 844 : 1080 };
    const { page } = await open(browser, '#lang=ru', { viewport });
    await opened(page, 'small.jsonl', small);
    await bookmark(page, 60, 'длинная заметка, которая не помещается в одну строку панели');
    await bookmark(page, 61, '');
    expect(await violations(page)).toEqual([]);
    const boxes = await page
      .locator('vidno-bookmarks :is(button, textarea)')
      .evaluateAll((all) => all.map((each) => each.getBoundingClientRect().toJSON() as DOMRect));
    for (const box of boxes) {
      expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(24);
      expect(box.right).toBeLessThanOrEqual(width);
    }
  });
});
