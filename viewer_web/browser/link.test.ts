import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { bookmark, listed } from './bookmarks.js';
import { browser } from './browser.js';
import { lessonTraces, open, openLesson as showLesson } from './page.js';

describe('a link', () => {
  const link = (text: string): string => Buffer.from(text, 'utf8').toString('base64url');

  /** Opens the first lesson, if the page was built with any. */
  async function openLesson(
    hash: string,
  ): Promise<{ page: Page; faults: readonly string[] } | null> {
    const opening = await open(browser, '#lang=en');
    const button = opening.page.locator('vidno-lesson-list button').first();
    if ((await button.count()) === 0) return null;
    const id = (await button.getAttribute('data-trace')) ?? '';
    const { page, faults } = await open(browser, `#lang=en&trace=${id}&view=workbench&${hash}`);
    await page.locator('.title h2').getByText(/./).waitFor();
    return { page, faults };
  }

  it('contains the bookmarks and restores them', async () => {
    const first = await openLesson('step=3');
    if (first === null) return;
    await bookmark(first.page, 40, 'здесь & там = «да» #1');
    await bookmark(first.page, 12, '');
    await first.page.waitForFunction(() => /bookmarks=.*step=12$/.test(location.hash));
    const { page, faults } = await open(browser, new URL(first.page.url()).hash);
    await page.locator('.title h2').getByText(/./).waitFor();
    await page.keyboard.press('Shift+B');
    await page.locator('[data-go="12"]:focus').waitFor();
    expect(await listed(page)).toEqual([
      [12, ''],
      [40, 'здесь & там = «да» #1'],
    ]);
    await showLesson(page, (await lessonTraces(page))[1] ?? '');
    await expect.poll(() => listed(page)).toEqual([]);
    expect(faults).toEqual([]);
  });

  it('from a stranger adds only bookmarks with text of bounded length', async () => {
    const evil = '<img src=x onerror=alert(1)>';
    const lines = [`5 ${evil}`, 'x', '6 \u202egnol', `7 ${'y'.repeat(300)}`, '999999999 far'];
    const opening = await openLesson(`step=5&bookmarks=${link(lines.join('\n'))}`);
    if (opening === null) return;
    const { page, faults } = opening;
    await page.keyboard.press('Shift+B');
    await page.locator('[data-go="5"]:focus').waitFor();
    expect(await listed(page)).toEqual([
      [5, evil],
      [6, 'gnol'],
      [7, 'y'.repeat(60)],
    ]);
    expect(await page.locator('.slider').getAttribute('aria-valuetext')).toContain(evil);
    expect(await page.locator('img[src="x"]').count()).toBe(0);
    expect(faults).toEqual([]);
  });
});
