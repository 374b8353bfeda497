import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { edit, rerun } from './live.js';
import { launch, open, opened, sampleTrace, whole } from './page.js';

let browser: Browser;
beforeAll(async () => {
  browser = await launch();
});
afterAll(async () => {
  await browser.close();
});

it('a trace with a usual mistake opens under its name; a changed scene is run by the corrected text, which is said', async () => {
  const { page, faults } = await open(browser, '#lang=en');
  await opened(page, 'one-list.jsonl', sampleTrace('one-list.warnock.signs'));
  const title = page.locator('div.title');
  expect(await title.textContent()).toContain('mistake: one list for all parts');
  await edit(page);
  const form = page.locator('vidno-run-form');
  expect(await form.locator('[name=edition]').inputValue()).toBe('corrected');
  expect(await form.locator('section > p:not(.rule)').textContent()).toContain(
    'made with a usual mistake',
  );
  await rerun(page, () => form.locator('select[name=kernel]').selectOption('exact'));
  await whole(page);
  expect(await title.textContent()).toContain('corrected');
  expect(faults).toEqual([]);
});
