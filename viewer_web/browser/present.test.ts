import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { goTo, open, opened, shown, small } from './page.js';

async function presenting(hash = '#lang=en'): Promise<{ page: Page; faults: readonly string[] }> {
  const { page, faults } = await open(browser, hash, { viewport: { width: 1280, height: 720 } });
  await opened(page, 'small.jsonl', small);
  await goTo(page, 60);
  await page.locator('input[type=number]').blur();
  await page.keyboard.press('f');
  await page.locator('.corner').waitFor();
  return { page, faults };
}

const step = async (page: Page): Promise<number> => (await shown(page)).step;

describe('the presentation', () => {
  it('is controlled by a presenter remote', async () => {
    const { page, faults } = await presenting();
    await page.keyboard.press('PageDown');
    await page.keyboard.press('PageDown');
    expect(await step(page)).toBe(62);
    await page.keyboard.press('PageUp');
    expect(await step(page)).toBe(61);
    expect(await page.locator('.corner').textContent()).toContain('61 / ');
    expect(faults).toEqual([]);
  });

  it('blanks the screen with B or a full stop, and shows it again at any key, which does nothing else', async () => {
    const { page } = await presenting();
    for (const [dark, light] of [
      ['b', 'PageDown'],
      ['.', '.'],
      ['b', 'Escape'],
    ] as const) {
      await page.keyboard.press(dark);
      const curtain = await page.locator('.curtain').boundingBox();
      expect(curtain).toEqual({ x: 0, y: 0, width: 1280, height: 720 });
      await page.keyboard.press(light);
      await page.locator('.curtain').waitFor({ state: 'detached' });
    }
    expect(await step(page)).toBe(60);
    expect(await page.locator('.corner').isVisible()).toBe(true);
  });

  it('is left by Escape, F or its button', async () => {
    const { page, faults } = await presenting();
    for (const leave of [
      () => page.keyboard.press('Escape'),
      () => page.keyboard.press('f'),
      () => page.getByRole('button', { name: 'Leave the presentation' }).click(),
    ]) {
      await leave();
      await page.locator('.corner').waitFor({ state: 'detached' });
      expect(await page.locator('vidno-transport').isVisible()).toBe(true);
      await page.getByRole('button', { name: 'Present' }).click();
      await page.locator('.corner').waitFor();
    }
    expect(faults).toEqual([]);
  });

  it('fills the window, with large type for listing and sentence', async () => {
    const { page } = await presenting();
    expect(await page.locator('vidno-player').boundingBox()).toEqual({
      x: 0,
      y: 0,
      width: 1280,
      height: 720,
    });
    // The window has 720 lines: a letter of the listing takes at least 18, one of the sentence 27.
    const size = (selector: string): Promise<number> =>
      page
        .locator(selector)
        .first()
        .evaluate((e) => Number.parseFloat(getComputedStyle(e).fontSize) * e.currentCSSZoom);
    expect(await size('vidno-listing code')).toBeGreaterThanOrEqual(18);
    expect(await size('.sentence')).toBeGreaterThanOrEqual(27);
    expect(await page.locator('vidno-page-header').isVisible()).toBe(true);
    expect(await page.locator('vidno-page-header').getAttribute('inert')).not.toBe(null);
  });

  it('lets a pixel be pointed at', async () => {
    const { page } = await presenting();
    const box = await page.locator('vidno-picture').boundingBox();
    if (box === null) throw new Error('no picture');
    // The area is 5 x 4 from (2, -1). Its middle is the corner of four pixels; a point close to it is in the pixel (4, 1).
    await page.mouse.click(box.x + box.width / 2 + 3, box.y + box.height / 2 + 3);
    const pixel = await page
      .locator('vidno-player')
      .evaluate((player: HTMLElementTagNameMap['vidno-player']) => player.pixel);
    expect(pixel).toEqual([4, 1]);
  });

  it('is kept in the link', async () => {
    const { page } = await open(browser, '#lang=en');
    if ((await page.locator('vidno-lesson-list button').count()) === 0) return;
    await page.locator('vidno-listing').waitFor();
    await page.keyboard.press('f');
    await page.waitForFunction(() => location.hash.includes('view=present'));
    const again = await open(browser, new URL(page.url()).hash);
    await again.page.locator('.corner').waitFor();
    await again.page.keyboard.press('Escape');
    await again.page.waitForFunction(() => !location.hash.includes('view=present'));
    expect(again.faults).toEqual([]);
  });

  it('is accessible', async () => {
    const { page } = await open(browser, '#lang=ru');
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('f');
    await page.locator('.corner').waitFor();
    expect(await violations(page)).toEqual([]);
  });
});
