import { readFileSync } from 'node:fs';
import type { Frame, Page } from 'playwright-core';
import { shown } from './page.js';

export const stepOf = async (page: Page): Promise<number> => (await shown(page)).step;

/** Waits for a question at a step, with the focus on it. */
export async function asked(page: Page | Frame, step: number): Promise<void> {
  await page.locator('vidno-question h3:focus').waitFor();
  await page.waitForFunction((wanted) => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    return player?.step === wanted;
  }, step);
}

export async function press(page: Page, ...keys: readonly string[]): Promise<void> {
  for (const key of keys) await page.keyboard.press(key);
}

/** The verdict on each part, and on the whole. */
export async function verdict(page: Page | Frame): Promise<readonly string[]> {
  await page.locator('vidno-question .result').waitFor();
  const said = await page.locator('vidno-question :is(legend b, .result)').allTextContents();
  return said.map((text) => text.trim());
}

/** The score as it is saved. */
export async function savedScore(page: Page): Promise<unknown> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('vidno-predict .save button').click(),
  ]);
  return JSON.parse(readFileSync(await download.path(), 'utf8'));
}
