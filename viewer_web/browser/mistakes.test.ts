import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { edit, handle, rerun, run, title } from './live.js';
import { open, opened, openLesson, sampleTrace, whole } from './page.js';

describe('a usual mistake', () => {
  it('of an opened trace is kept when its scene runs again', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'one-list.jsonl', sampleTrace('one-list.warnock.signs'));
    const name = page.locator('vidno-run-words button').first();
    expect(await name.textContent()).toContain('mistake: one list for all parts');
    const { lines } = await run(page);
    await edit(page);
    const select = (field: string) => page.locator(`vidno-run-form select[name=${field}]`);
    expect(await select('edition').inputValue()).toBe('one-list');
    expect(await select('kernel').locator('option').allTextContents()).toEqual(['double', 'exact']);
    await rerun(page, () => select('kernel').selectOption('exact'));
    expect(await name.textContent()).toContain('mistake: one list for all parts');
    const again = await rerun(page, () => select('kernel').selectOption('double'));
    expect(again).toMatchObject({ edition: 'one-list', lines });
    expect(faults).toEqual([]);
  });

  it('is chosen for a scene: the page writes what the program wrote, and keeps the mistake as a corner moves', async () => {
    const lesson = '09-usual-mistakes.mistakes.warnock.double';
    const { page, faults } = await open(browser, `#lang=en&trace=${lesson}.surround-kept.polygons`);
    await page.locator(title, { hasText: /./u }).waitFor();
    await whole(page);
    const { lines } = await run(page);
    await rerun(page, () => openLesson(page, `${lesson}.corrected.polygons`));
    await whole(page);
    expect((await run(page)).lines).not.toEqual(lines);
    await edit(page);
    const choose = (field: string, value: string) => () =>
      page.locator(`vidno-run-form select[name=${field}]`).selectOption(value);
    const chosen = await rerun(page, choose('edition', 'surround-kept'));
    expect(chosen).toMatchObject({ edition: 'surround-kept', kernel: 'double' });
    expect(chosen.lines).toEqual(lines);
    await page.locator(handle(0, 0)).focus();
    const moved = await rerun(page, () => page.keyboard.press('ArrowRight'));
    expect(moved.polygons[0]?.vertices[0]).toEqual([2.25, 1, 0.5]);
    expect(moved.edition).toBe('surround-kept');
    expect(moved.lines).not.toEqual(lines);
    // No other method can make this mistake.
    expect(await rerun(page, choose('method', 'zbuffer'))).toMatchObject({ edition: 'corrected' });
    expect(faults).toEqual([]);
  });
});
