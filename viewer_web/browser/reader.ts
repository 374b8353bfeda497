import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import type { Browser, BrowserContextOptions, Locator, Page } from 'playwright-core';
import { jsonInPage } from '../src/base/markup.js';
import { indexEntry, sampleLesson, shortLesson } from '../src/testing/lessons.js';
import { built } from './browser.js';
import { openUrl, sampleTrace } from './page.js';
import type { Opened } from './page.js';

/** The page's lesson blocks, without the content that the build has put into them. */
const blocks =
  /<script type="application\/(?:json" id="vidno-lessons|octet-stream" data-vidno-file)[^]*?<\/script>/g;

const folder = mkdtempSync(join(tmpdir(), 'vidno-'));
process.once('exit', () => {
  rmSync(folder, { recursive: true });
});

/** The files of the pages written so far, by lesson. */
const written = new Map<string, string>();

/** A page in a file, as `vidno page` makes it, with three lessons, the last without a text. */
function pageOf(lesson: object): string {
  const key = JSON.stringify(lesson);
  let file = written.get(key);
  if (file === undefined) {
    file = join(folder, `page-${written.size}.html`);
    writeFileSync(file, contentOf(lesson));
    written.set(key, file);
  }
  return file;
}

function contentOf(lesson: object): string {
  const stories = { 'first.lesson.json': lesson, 'second.lesson.json': shortLesson('second') };
  const files = [
    ...['small.warnock.signs', 'small.zbuffer.signs'].map(
      (name) => [`${name}.jsonl`, Buffer.from(sampleTrace(name))] as const,
    ),
    ...Object.entries(stories).map(
      ([name, story]) => [name, gzipSync(JSON.stringify(story))] as const,
    ),
  ];
  const index = [
    indexEntry('first', ['warnock', 'zbuffer'], 'first.lesson.json'),
    indexEntry('second', ['zbuffer'], 'second.lesson.json'),
    indexEntry('third', ['warnock']),
  ];
  const data = [
    `<script type="application/json" id="vidno-lessons">${jsonInPage(index)}</script>`,
    ...files.map(
      ([name, bytes]) =>
        `<script type="application/octet-stream" data-vidno-file="${name}">${bytes.toString('base64')}</script>`,
    ),
  ];
  const page = readFileSync(built, 'utf8').replace(blocks, '');
  return page.replace('</body>', () => `${data.join('')}</body>`);
}

/** Opens a page with a lesson that has a text, a second such lesson, and one without. */
export async function openReader(
  browser: Browser,
  hash: string,
  options: BrowserContextOptions = {},
  lesson: object = sampleLesson(),
): Promise<Opened> {
  const url = pathToFileURL(pageOf(lesson)).href + hash;
  const opened = await openUrl(browser, url, {
    viewport: { width: 1440, height: 900 },
    ...options,
  });
  // On a phone the text may lie in front of it.
  await opened.page.locator('vidno-listing').waitFor({ state: 'attached' });
  // A picture that loads later scrolls the text back to its previous position.
  await opened.page.locator('vidno-reader img').evaluateAll(async (all) => {
    await Promise.all(all.map((image) => (image as HTMLImageElement).decode()));
  });
  return opened;
}

export const pin = (page: Page, place: string): Locator =>
  page.locator(`.pin[data-place="${place}"]`);

/** Scrolls like a reader, so that the place is a little above the reading line. */
export async function readTo(page: Page, place: string): Promise<void> {
  await page.locator('vidno-reader .box').hover();
  const by = await pin(page, place).evaluate((mark) => {
    const box = mark.closest('.box')?.getBoundingClientRect() ?? new DOMRect();
    return mark.getBoundingClientRect().bottom - box.top - box.height / 3 + 8;
  });
  await page.mouse.wheel(0, by);
}

/** The current position: the method of the run, the step, and the marked pin. */
export function standing(page: Page): Promise<readonly unknown[]> {
  return page.evaluate(() => {
    const root = document.querySelector('vidno-app')?.shadowRoot;
    const player = root?.querySelector('vidno-player');
    const marked = root
      ?.querySelector('vidno-reader')
      ?.shadowRoot?.querySelector('.pin[aria-current]');
    return [player?.trace?.header.method, player?.step, marked?.getAttribute('data-place')];
  });
}

export const scrolled = (page: Page): Promise<number> =>
  page.locator('vidno-reader .box').evaluate((box) => box.scrollTop);
