import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { title } from './live.js';
import { goTo, open, opened, shown, small } from './page.js';
import { asked, press, stepOf } from './predict.js';

const panel = (page: Page): Promise<string | null> =>
  page.locator('vidno-side button[aria-pressed=true]').getAttribute('class');
const news = async (page: Page): Promise<string> =>
  ((await page.locator('.news').textContent()) ?? '').trim();

/** Escape closes the map a moment after the key. Until then another key goes to the map. */
async function leaveMap(page: Page): Promise<void> {
  await press(page, 'Escape');
  await page.locator('vidno-keys dialog').waitFor({ state: 'hidden' });
}

async function ready(hash = '#lang=en'): Promise<Page> {
  const { page } = await open(browser, hash);
  await opened(page, 'small.jsonl', small);
  await page.locator(title).click();
  return page;
}

describe('keys of one letter', () => {
  it('can be changed and turned off, and the address keeps that', async () => {
    const page = await ready();
    await press(page, '?');
    await page.locator('vidno-keys [data-key=X]').press('k');
    expect(await violations(page)).toEqual([]);
    await leaveMap(page);
    await press(page, 'x');
    expect(await panel(page)).toBe('state');
    await press(page, 'k');
    await expect.poll(() => panel(page)).toBe('exact');
    await page.locator('vidno-side button.exact[title="Exact? (K)"]').waitFor();
    await press(page, 'k', '?');
    await page.locator('vidno-keys .everywhere').uncheck();
    await leaveMap(page);
    await press(page, 'k', '?', ',', 'e');
    expect(await page.locator('vidno-keys dialog').isVisible()).toBe(false);
    expect(await panel(page)).toBe('state');
    await press(page, 'ArrowRight');
    expect(await stepOf(page)).toBe(1);
    await page.waitForFunction(() => location.hash.includes('keys=off.KX.XK'));

    // The run came from a file, which an address cannot hold; a first lesson is opened instead.
    const hash = new URL(page.url()).hash.replace(/trace=unheld&?/u, '');
    const again = await open(browser, `${hash}&view=workbench`);
    await again.page.locator(title, { hasText: /./u }).waitFor();
    await press(again.page, 'k');
    expect(await panel(again.page)).toBe('state');
    await again.page.getByRole('button', { name: 'Keys' }).click();
    await again.page.getByRole('button', { name: 'Reset all keys' }).click();
    await leaveMap(again.page);
    await press(again.page, 'x');
    await expect.poll(() => panel(again.page)).toBe('exact');
  });

  it('announce what they opened, or why they did not', async () => {
    const page = await ready();
    await press(page, 'x');
    await expect.poll(() => news(page)).toBe('Panel: Exact?');
    await press(page, 'v');
    await expect.poll(() => news(page)).toBe('Panel: 3D');
    await press(page, 'f');
    await expect.poll(() => news(page)).toContain('Esc leaves');
    await press(page, 'Escape');
    await expect.poll(() => news(page)).toBe('The presentation is over.');
  });

  it('work while a question is open, wherever the focus is in it', async () => {
    const page = await ready();
    await press(page, 'q');
    await asked(page, 4);
    await page.locator('vidno-question input[type=radio]').first().focus();
    await press(page, 'x');
    await expect.poll(() => panel(page)).toBe('exact');
    await press(page, 'v', 'v', 'q');
    await page.locator('vidno-question input[type=radio]').first().focus();
    await press(page, 'Escape');
    expect(await panel(page)).toBe('state');
    expect(await page.locator('vidno-question').count()).toBe(0);
    await press(page, 'q');
    await page.locator('vidno-question input[type=radio]').first().focus();
    await press(page, 'd');
    await page.locator('vidno-rival-choice dialog[open]').waitFor();
    await press(page, 'Escape');

    // If the run waits for the answer, the page says so.
    await page.locator('vidno-predict .force').check();
    await page.locator('vidno-question input[type=radio]').first().focus();
    await press(page, 'Escape');
    await page.getByText('The run waits for an answer').waitFor();
    expect(await panel(page)).toBe('predict');
    await press(page, 'd');
    await page.getByText('the other run would show the answer').waitFor();
  });
});

describe('by keyboard', () => {
  // A touch screen shows the panels about the step from the start; elsewhere they appear where the pointer is.
  it.each([false, true])(
    'reach Play with twelve presses of Tab, or with two (touch: %s)',
    async (isTouch) => {
      const { page } = await open(browser, '#lang=en', { hasTouch: isTouch, isMobile: isTouch });
      await page.locator(title, { hasText: /./u }).waitFor();
      const focused = (): Promise<string> =>
        page.evaluate(() => {
          let at: Element | null = document.activeElement;
          while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
          return at?.getAttribute('aria-label') ?? at?.textContent.trim() ?? '';
        });
      await expect.poll(() => page.locator('.asides .exact').isVisible()).toBe(isTouch);
      await press(page, 'Tab');
      expect(await focused()).toBe('To the controls');
      const skip = await page.getByRole('button', { name: 'To the controls' }).boundingBox();
      expect(skip?.height).toBeGreaterThan(20);
      let presses = 1;
      for (; presses < 30 && !(await focused()).startsWith('Play'); presses++)
        await press(page, 'Tab');
      expect(presses).toBeLessThanOrEqual(12);
      await page.getByRole('button', { name: 'To the controls' }).focus();
      await press(page, 'Enter');
      expect(await focused()).toMatch(/^Play/);
    },
  );

  it('the facts about each pixel are announced', async () => {
    const page = await ready();
    await press(page, 'End', 'p');
    const heard = page.locator('vidno-picture [aria-live]');
    await expect.poll(() => heard.textContent()).toMatch(/^Pixel \(\d+, \d+\): \w+, #[0-9a-f]{6}/);
    const last = await shown(page);
    await press(page, 'Escape');
    await goTo(page, 0);
    await page.locator(title).click();
    await press(page, 'p');
    await expect.poll(() => heard.textContent()).toMatch(/^Pixel \(\d+, \d+\): not painted yet$/);
    expect(last.step).toBe(last.length);
  });
});
