import { readFileSync, statSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { bookmark, listed } from './bookmarks.js';
import { browser, built } from './browser.js';
import { edit, openScene, rerun, run, scene, title, triangle } from './live.js';
import { goTo, open, openUrl, opened, shown, small, whole } from './page.js';
import { temporaryFile } from './temporary.js';

/** Saves the page in its current state. */
async function saved(page: Page): Promise<string> {
  await page.locator(title).click(); // the step field would take the letters
  if (!(await page.locator('vidno-scene-panel').isVisible())) await edit(page);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save page' }).click(),
  ]);
  const name = download.suggestedFilename();
  expect(name).toMatch(/step-\d+\.html$/);
  const file = temporaryFile(name);
  await download.saveAs(file);
  return file;
}

const openSaved = (file: string): ReturnType<typeof openUrl> =>
  openUrl(browser, pathToFileURL(file).href);

describe('a page on disk, whose address works for nobody else, is saved as another page', () => {
  it('with a trace of the reader’s own, the step, the bookmarks and the setup', async () => {
    const { page } = await open(browser, '#lang=en&speed=2');
    await opened(page, 'own.jsonl', small);
    await bookmark(page, 12, 'здесь </script> & там');
    await goTo(page, 40);
    const before = await run(page);
    const file = await saved(page);
    expect(await page.locator('vidno-scene-panel .message').textContent()).toContain(
      'Send the file',
    );

    const again = await openSaved(file);
    await again.page.locator(title, { hasText: 'A square, a triangle and a slope' }).waitFor();
    await whole(again.page);
    expect(await run(again.page)).toEqual(before);
    expect((await shown(again.page)).step).toBe(40);
    await again.page.keyboard.press('Shift+B');
    expect(await listed(again.page)).toEqual([[12, 'здесь </script> & там']]);
    expect(await again.page.locator('vidno-lesson-list button').count()).toBe(1);
    expect(again.faults).toEqual([]);
    expect(statSync(file).size).toBeLessThan(statSync(built).size * 0.75);
    expect(readFileSync(file, 'utf8')).toContain('This page contains:');
  });

  it('with a scene that is too large for a link', async () => {
    const { page } = await open(browser, '#lang=en');
    // It lies beside the area, so that the run is short. Its digits do not fit into the 16,000 characters of an address.
    const vertices = triangle.vertices.map(([x, y], i) => [x, y, Number(`0.${i + 1}`)]);
    const corner = (i: number): number[][] =>
      vertices.map(([x = 0, y = 0]) => [
        x + 50 + Math.sin(i),
        y + Math.cos(i),
        Math.sin(i * i) / 2,
      ]);
    const all = Array.from({ length: 400 }, (_, i) => ({
      ...triangle,
      id: `T${i}`,
      vertices: corner(i),
    }));
    await openScene(page, scene(all));
    await goTo(page, 30);
    const before = await run(page);
    const again = await openSaved(await saved(page));
    await again.page.locator(title, { hasText: 'Two' }).waitFor();
    expect(await run(again.page)).toEqual(before);
    expect((await shown(again.page)).step).toBe(30);
    expect(again.faults).toEqual([]);
  });

  it('with the lesson, its text and an edited scene of it', async () => {
    const { page } = await open(browser, '#lang=en');
    await page.locator(title, { hasText: /./u }).waitFor();
    await goTo(page, 9);
    const lesson = await openSaved(await saved(page));
    await lesson.page.locator(title, { hasText: /./u }).waitFor();
    await whole(lesson.page);
    expect(await run(lesson.page)).toEqual(await run(page));
    expect((await shown(lesson.page)).step).toBe(9);
    await lesson.page.locator('vidno-reader h2', { hasText: /./u }).waitFor();

    const changed = await rerun(page, () =>
      page.locator('vidno-run-form select[name=kernel]').selectOption('float'),
    );
    const scenePage = await openSaved(await saved(page));
    await scenePage.page.locator(title, { hasText: /./u }).waitFor();
    await expect.poll(async () => (await run(scenePage.page)).lines).toEqual(changed.lines);
    expect([...lesson.faults, ...scenePage.faults]).toEqual([]);
  });

  it('with a trace that this page keeps once for two lessons', async () => {
    const file = '11-warnock-family.warnock.double.corrected.signs';
    const { page } = await open(browser, `#lang=en&trace=${file}`);
    await page.locator(title, { hasText: /./u }).waitFor();
    await whole(page);
    const same = page.locator(`script[data-vidno-file="${file}.jsonl.gz"]`);
    expect(await same.getAttribute('data-vidno-same')).toMatch(/^01-four-relations/u);
    const lesson = await openSaved(await saved(page));
    await lesson.page.locator(title, { hasText: /./u }).waitFor();
    await whole(lesson.page);
    expect(await run(lesson.page)).toEqual(await run(page));
  });
});
