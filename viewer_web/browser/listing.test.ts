import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser, settled } from './browser.js';
import { goTo, open, opened, shown, small } from './page.js';

/** The note beside a line. */
const beside = (page: Page, label: string): Promise<string | null> =>
  page
    .locator('vidno-listing section li', { has: page.locator(`.at:text-is("${label}")`) })
    .locator('var')
    .textContent();

/** The vertical position of each line of the listing. */
const places = (page: Page): Promise<readonly number[]> =>
  page
    .locator('vidno-listing section li')
    .evaluateAll((lines) => lines.map((line) => (line as HTMLElement).offsetTop));

describe('the listing', () => {
  it('has the values of the events beside its lines, and no line moves', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    const still = await places(page);
    const lines = small.split('\n');
    for (let step = 0; step < 60; step++) {
      await page.keyboard.press('ArrowRight');
      const event = JSON.parse(lines[step + 1] ?? '') as Record<string, unknown>;
      await shown(page);
      if (event['e'] === 'count') expect(await beside(page, 'PW4')).toBe(String(event['count']));
      if (event['e'] === 'nearer')
        expect(await beside(page, 'PW6')).toBe(`k = ${String(event['k'])}`);
      if (event['e'] === 'surround') {
        expect(await beside(page, String(event['at']))).toBe(String(event['inside']));
      }
      expect(await places(page)).toEqual(still);
    }
    expect(faults).toEqual([]);
  });

  it('becomes the C++ of the library and back, by key and by button', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    const first = small.split('\n').findIndex((line) => line.includes('"e":"orient"'));
    await goTo(page, first);
    await page.locator('input[type=number]').evaluate((input: HTMLElement) => {
      input.blur();
    });
    await page.keyboard.press('c');
    const source = page.locator('vidno-cpp');
    const now = source.locator('[aria-current=step]');
    expect((await now.textContent())?.trim()).toMatch(/^trace\.orient\(.*S2.*S3.*\);$/);
    await now.click({ trial: true }); // it is in sight
    await page.keyboard.press('c');
    expect(await source.count()).toBe(0);
    await page.getByRole('button', { name: 'C++' }).focus();
    await page.keyboard.press('Enter');
    expect(await source.locator('h3').first().textContent()).toBe('warnock/warnock.h');
    expect(await violations(page)).toEqual([]);
    expect(faults).toEqual([]);
  });

  it('keeps the current line in sight, in a lower window too', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    const isInSight = (): Promise<boolean> =>
      page.locator('vidno-listing .now').evaluate((line) => {
        const box = line.closest('.procedures')?.getBoundingClientRect();
        const { top, bottom } = line.getBoundingClientRect();
        return box !== undefined && top >= box.top && bottom <= box.bottom;
      });
    for (const step of [60, 400, 800]) {
      await goTo(page, step);
      await expect.poll(isInSight).toBe(true);
    }
    await page.setViewportSize({ width: 1280, height: 620 });
    await expect.poll(isInSight).toBe(true);
  });

  it('has the names of the text below the procedures, on request', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    const names = page.locator('vidno-listing details');
    expect(await names.locator('dl').isVisible()).toBe(false);
    await names.locator('summary').click();
    const row = names.locator('dt', { hasText: 'псевдоскалярное произведение' });
    expect(await row.locator('xpath=following-sibling::dd[1]').textContent()).toContain('u × v');
    const [wide, panel] = await Promise.all(
      [names.locator('dl'), page.locator('vidno-listing')].map((each) => each.boundingBox()),
    );
    expect(wide?.width).toBeLessThanOrEqual(panel?.width ?? 0);
    expect(await violations(page)).toEqual([]);
    expect(faults).toEqual([]);
  });

  it('stays where the reader has scrolled to until the current line changes', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await goTo(page, 400);
    await settled(page);
    const list = page.locator('vidno-listing .procedures');
    const top = (): Promise<number> => list.evaluate((element) => element.scrollTop);
    expect(await top()).toBeGreaterThan(0);
    await list.evaluate((element) => (element.scrollTop = 0));
    await page.locator('vidno-warnock .apl tr').first().hover(); // redraws the step
    await settled(page);
    expect(await top()).toBe(0);
    await goTo(page, 401);
    await expect.poll(top).toBeGreaterThan(0);
  });
});
