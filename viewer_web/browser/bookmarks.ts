import type { Page } from 'playwright-core';
import { goTo, shown } from './page.js';

/** The rows of the list of bookmarks, from top to bottom. */
export const listed = (page: Page): Promise<readonly (readonly [number, string])[]> =>
  page
    .locator('vidno-bookmarks li')
    .evaluateAll((items) =>
      items.map((item) => [
        Number(item.querySelector('.go')?.textContent),
        item.querySelector('textarea')?.value ?? '',
      ]),
    );

/** Bookmarks a step, by keyboard. */
export async function bookmark(page: Page, step: number, note: string): Promise<void> {
  await goTo(page, step);
  await page.locator('input[type=number]').blur();
  await page.keyboard.press('b');
  await page.locator(`textarea[data-note="${step}"]:focus`).waitFor();
  await page.keyboard.type(note);
  await page.keyboard.press('Enter');
  await shown(page);
}
