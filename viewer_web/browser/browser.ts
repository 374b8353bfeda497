import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';

/** The page as it was built. */
export const built = fileURLToPath(new URL('../dist/index.html', import.meta.url));

/** A browser; further flags for what needs them. */
export function launch(...flags: readonly string[]): Promise<Browser> {
  if (!existsSync(built)) throw new Error('Build the page first: npm run build');
  return chromium.launch({
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: [
      '--headless=new',
      '--no-sandbox',
      '--disable-gpu',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      ...flags,
    ],
  });
}

/** The browser of this process, whose test files share it. */
export const browser = await launch();

interface Tab {
  readonly of: Browser;
  /** The options that cannot be changed afterwards. */
  readonly kind: string;
  readonly page: Page;
  uses: number;
}

// A context of its own and a process that has seen no script take three quarters of the time to open a page. Beside its
// address the page keeps sizes alone, which are cleared, so that a tab at about:blank is as good as new.
const idle: Tab[] = [];
const inUse: Tab[] = [];

/** What earlier pages have left in the process's memory is not carried along for ever. */
const mostUses = 40;

/** An empty page; after the test it is taken back. */
export async function emptyPage(of: Browser, options: BrowserContextOptions = {}): Promise<Page> {
  const { viewport, colorScheme = 'light', ...others } = options;
  const kind = JSON.stringify(others);
  const found = idle.findIndex((tab) => tab.of === of && tab.kind === kind);
  const [tab = await newTab(of, kind, others)] = found < 0 ? [] : idle.splice(found, 1);
  inUse.push(tab);
  tab.uses++;
  await tab.page.setViewportSize(viewport ?? { width: 1280, height: 800 });
  await tab.page.emulateMedia({ media: null, colorScheme });
  return tab.page;
}

async function newTab(of: Browser, kind: string, options: BrowserContextOptions): Promise<Tab> {
  const context = await of.newContext(options);
  await context.addInitScript(noteTimers);
  return { of, kind, page: await context.newPage(), uses: 0 };
}

/** Runs in the page, before its own script: keeps which of its timers are still to come. */
function noteTimers(): void {
  const { setTimeout: start, clearTimeout: stop } = window;
  const timers = new Set<number>();
  const setTimer = (act: () => void, after?: number): number => {
    const timer = start(() => {
      timers.delete(timer);
      act();
    }, after);
    timers.add(timer);
    return timer;
  };
  const clearTimer = (timer: number): void => {
    timers.delete(timer);
    stop(timer);
  };
  Object.assign(window, { timers, setTimeout: setTimer, clearTimeout: clearTimer });
}

/** Waits until the page has drawn what was done to it, and nothing is left that it wanted to do later. */
export function settled(page: Page): Promise<void> {
  return page.evaluate(async () => {
    const { timers } = window as unknown as { timers: ReadonlySet<number> };
    const frame = (): Promise<number> => new Promise(requestAnimationFrame);
    do {
      await frame();
      await frame();
    } while (timers.size > 0);
  });
}

/** Takes back the pages of a test, and closes what it may have left in disorder. */
export async function takeBack(isInOrder: boolean): Promise<void> {
  await Promise.all(
    inUse.splice(0).map(async (tab) => {
      const { page, uses } = tab;
      if (page.isClosed()) return;
      page.removeAllListeners();
      if (!isInOrder || uses >= mostUses) return page.context().close();
      // A page that was written into a blank tab has no storage.
      if (!page.url().startsWith('about:')) await page.evaluate(() => localStorage.clear());
      await page.goto('about:blank');
      // Else the next page would be under the mouse where this one was.
      await page.mouse.move(-1, -1);
      idle.unshift(tab);
    }),
  );
}
