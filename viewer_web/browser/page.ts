import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import type { AppElement } from '../src/app/app.js';
import { built, emptyPage } from './browser.js';
import { temporaryFile } from './temporary.js';

/** A trace of the test data, as text. */
export function sampleTrace(name: string): string {
  return readFileSync(new URL(`../test-data/${name}.jsonl`, import.meta.url), 'utf8');
}

/** The events of a trace, repeated up to a number of events: no pixel of a real run has such a long history. */
export function repeated(text: string, from: RegExp, length: number): string {
  const [header = '', ...lines] = text.trim().split('\n');
  const start = lines.findIndex((line) => from.test(line));
  const body = lines.slice(start, -1);
  const times = Math.ceil(length / body.length);
  const events = start + times * body.length;
  const end = { end: { events, picture: `sha256:${'0'.repeat(64)}` } };
  const all = Array.from({ length: times }, () => body).flat();
  return [header, ...lines.slice(0, start), ...all, JSON.stringify(end), ''].join('\n');
}

/** A trace with every kind of window. */
export const small = sampleTrace('small.warnock.signs');

/** The page opened from disk, with everything it did that it must not do. */
export interface Opened {
  readonly page: Page;
  readonly faults: readonly string[];
}

export async function open(
  browser: Browser,
  hash = '',
  options: BrowserContextOptions = {},
): Promise<Opened> {
  const opened = await openUrl(browser, pathToFileURL(built).href + hash, options);
  await opened.page.locator('vidno-app header').waitFor();
  return opened;
}

export async function openUrl(
  browser: Browser,
  url: string,
  options: BrowserContextOptions = {},
): Promise<Opened> {
  const page = await emptyPage(browser, options);
  const faults: string[] = [];
  page.on('pageerror', (error) => faults.push(error.message));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('request', (request) => {
    // The page makes the script of its worker, a blob, from its own text.
    if (!/^(file|blob):/.test(request.url())) faults.push(request.url());
  });
  await page.goto(url);
  return { page, faults };
}

/** What the player shows, read in the page. */
export interface Shown {
  readonly step: number;
  readonly length: number;
  readonly sentence: string;
  readonly line: string | null;
}

export function shown(page: Page): Promise<Shown> {
  return page.evaluate(async () => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    if (!player) throw new Error('no player');
    await player.updateComplete;
    const root = player.shadowRoot;
    const listing = root?.querySelector('vidno-listing');
    await listing?.updateComplete;
    return {
      step: player.step,
      length: player.length,
      sentence: root?.querySelector('.sentence')?.textContent.replace(/\s+/g, ' ').trim() ?? '',
      line: listing?.shadowRoot?.querySelector('[aria-current] .at')?.textContent ?? null,
    };
  });
}

/** Acts, and waits until the player shows another trace than before. */
export async function showsAnother(page: Page, act: () => Promise<unknown>): Promise<void> {
  await page.evaluate(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    Object.assign(window, { before: player?.trace });
  });
  await act();
  await page.waitForFunction(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    return player?.trace && player.trace !== (window as unknown as { before: unknown }).before;
  });
}

/** Opens a file that is a trace and waits until the whole of it is shown. */
export async function opened(page: Page, name: string, content: string | Buffer): Promise<void> {
  await showsAnother(page, () => openFile(page, name, content));
  await isOpen(page, name);
  await whole(page);
}

/** Waits until the trace in a file of this name is shown. */
export async function isOpen(page: Page, name: string): Promise<void> {
  await page.waitForFunction((file) => {
    const app = document.querySelector<AppElement>('vidno-app');
    return app?.session.file?.name === file;
  }, name);
}

/** Waits until everything is read. */
export async function whole(page: Page): Promise<void> {
  await page.locator('vidno-notice :is(.reading, .growing)').waitFor({ state: 'detached' });
}

/** Opens the list of lessons and files, which covers the page. */
export async function openContents(page: Page): Promise<void> {
  await page.locator('vidno-page-header button.contents').click();
  await page.locator('vidno-lesson-list').waitFor();
}

/** The traces of all lessons, as the page's address names them. */
export function lessonTraces(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const index = document.getElementById('vidno-lessons')?.textContent ?? '[]';
    const lessons = JSON.parse(index) as { traces: { file: string }[] }[];
    return lessons.flatMap(({ traces }) =>
      traces.map(({ file }) => file.replace(/\.jsonl(\.gz)?$/, '')),
    );
  });
}

/** Opens a trace of a lesson by its address, in the workbench, and waits until it is shown. */
export async function openLesson(page: Page, trace: string): Promise<void> {
  await page.evaluate(
    async (hash) => {
      // The page's own change of the address may replace this one before it is read.
      do {
        location.hash = hash;
        await new Promise((resolve) => {
          window.addEventListener('hashchange', resolve, { once: true });
        });
      } while (location.hash !== hash);
    },
    `#trace=${encodeURIComponent(trace)}&view=workbench`,
  );
  const button = page.locator(`button[data-trace="${trace}"][aria-pressed="true"]`);
  await button.waitFor({ state: 'attached' });
}

export async function goTo(page: Page, step: number): Promise<void> {
  const field = page.locator('.dock input[type=number]');
  await field.fill(String(step));
  await field.press('Enter');
}

/** The positions and sizes of parts of the page; equal strings mean that nothing has moved. */
export function placesOf(page: Page, parts: string): Promise<string> {
  return page.locator(parts).evaluateAll((all) =>
    all
      .map((part) => part.getBoundingClientRect())
      .map(({ x, y, width, height }) => [x, y + scrollY, width, height].map(Math.round).join())
      .join(' '),
  );
}

/** The width of the page; it equals that of the window if nothing sticks out. */
export const widthOf = (page: Page): Promise<number> =>
  page.evaluate(() => document.documentElement.scrollWidth);

/** The texts of the parts of the page that are cut off. */
export function cutOff(page: Page, parts: string): Promise<readonly string[]> {
  return page
    .locator(parts)
    .evaluateAll((all) =>
      all.filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.textContent),
    );
}

/** Opens a file from disk. A large file that is sent to the browser as text would take longer than Playwright waits. */
export async function openFile(page: Page, name: string, content: string | Buffer): Promise<void> {
  const file = temporaryFile(name);
  writeFileSync(file, content);
  await page.locator('vidno-file-drop input').setInputFiles(file);
}
