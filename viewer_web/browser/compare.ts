import type { Browser, BrowserContextOptions, Locator, Page } from 'playwright-core';
import { open } from './page.js';
import type { Opened } from './page.js';

/** Opens two runs beside each other, with complete counters. */
export async function comparing(
  browser: Browser,
  hash: string,
  options: BrowserContextOptions = {},
): Promise<Opened> {
  const opened = await open(browser, `#lang=en&${hash}`, options);
  await compared(opened.page);
  return opened;
}

/** Waits until the comparison is complete. */
export async function compared(page: Page): Promise<void> {
  await page.locator('vidno-comparison-facts').waitFor();
  await page.locator('.parting', { hasNotText: /searching|поиск/u }).waitFor();
  await page.locator('.differ', { hasText: /end|конце|same/u }).waitFor();
}

/** The steps of both runs. */
export function stepsOf(page: Page): Promise<readonly number[]> {
  return page.evaluate(async () => {
    const pair = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-comparison');
    await pair?.updateComplete;
    const runs = pair?.shadowRoot?.querySelectorAll('vidno-compared-run') ?? [];
    return [...runs].map(({ view }) => view.step);
  });
}

/** The sentences of both runs. */
export const sentences = (page: Page): Promise<readonly string[]> =>
  page.locator('vidno-compared-run .sentence .at').allTextContents();

/** The names of the two runs. */
export const names = (page: Page): Promise<readonly string[]> =>
  page.locator('vidno-compared-run .name > h3').allTextContents();

export const differ = (page: Page): Locator => page.locator('.differ');

/** A counter of both runs: up to the step / in all. */
export const counter = async (page: Page, name: string): Promise<readonly string[]> =>
  (await page.locator(`vidno-comparison-facts dl .${name} dd`).allTextContents()).map((text) =>
    text.replace(/^.*:/u, '').replace(/\s+/gu, ''),
  );
