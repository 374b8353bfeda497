import { gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { isOpen, open, openFile, repeated, sampleTrace, shown, small, whole } from './page.js';

const events = 1_000_000;
/** The name of the scene in both traces. */
const sceneName = 'A square, a triangle and a slope';

/** Measurements of opening a file: milliseconds, and how often the page reported progress. */
interface Opening {
  readonly first: number;
  readonly whole: number;
  readonly growing: number;
}

/** Records, from the choice of a file on, when its trace is shown and when all of it is read. */
const watchOpening = (page: Page): Promise<void> =>
  page.evaluate((title) => {
    const root = document.querySelector('vidno-app')?.shadowRoot;
    const input = root?.querySelector('vidno-file-drop')?.shadowRoot?.querySelector('input');
    const notice = root?.querySelector('vidno-notice')?.shadowRoot;
    input?.addEventListener('change', () => {
      const start = performance.now();
      const opening = { first: 0, whole: 0, growing: 0 };
      const said = new Set<string>();
      Object.assign(window, { opening });
      const look = (): void => {
        const now = performance.now() - start;
        const isShown = root?.querySelector('.title h2')?.textContent.trim() === title;
        if (isShown && opening.first === 0) opening.first = now;
        const text = notice?.querySelector('.growing')?.textContent;
        if (text) said.add(text);
        opening.growing = said.size;
        if (isShown && !notice?.querySelector('.reading, .growing')) opening.whole = now;
        else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    });
  }, sceneName);

async function openingOf(page: Page, name: string, content: string | Buffer): Promise<Opening> {
  await watchOpening(page);
  await openFile(page, name, content);
  const found = await page.waitForFunction(() => {
    const { opening } = window as unknown as { opening?: Opening };
    return opening !== undefined && opening.whole > 0 ? opening : null;
  });
  const opening = await found.jsonValue();
  if (opening === null) throw new Error('the trace was not opened');
  return opening;
}

/** Sorted milliseconds of seeks to distant steps in both directions: to the state alone, and until the page shows it. */
interface Seeks {
  readonly state: readonly number[];
  readonly shown: readonly number[];
}

const seeks = (page: Page): Promise<Seeks> =>
  page.evaluate(async () => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    if (!player?.trace) throw new Error('no trace');
    const { timeline } = player.trace;
    const times = { state: [] as number[], shown: [] as number[] };
    for (let i = 1; i <= 300; i++) {
      const step = (i * 618_034) % timeline.length;
      const start = performance.now();
      timeline.seek(step);
      times.state.push(performance.now() - start);
      player.step = (step + 300_000) % timeline.length;
      const middle = performance.now();
      await player.updateComplete;
      times.shown.push(performance.now() - middle);
    }
    times.state.sort((a, b) => a - b);
    times.shown.sort((a, b) => a - b);
    return times;
  });

const at99 = (times: readonly number[]): number =>
  times[Math.ceil(0.99 * times.length) - 1] ?? Infinity;

/** Megabytes of the page's scripts, in objects and in buffers. */
async function memory(page: Page): Promise<number> {
  const session = await page.context().newCDPSession(page);
  const used = (await session.send('Runtime.getHeapUsage')) as unknown as Record<string, number>;
  const { usedSize = NaN, backingStorageSize = NaN, embedderHeapUsedSize = NaN } = used;
  return (usedSize + backingStorageSize + embedderHeapUsedSize) / 2 ** 20;
}

const warnock = (): string => repeated(small, /"at":"W3"/, events);
const zbuffer = (): string => repeated(sampleTrace('small.zbuffer.signs'), /"e":"polygon"/, events);

describe('a trace of a million events', () => {
  it.each([
    ['warnock.jsonl', warnock],
    ['zbuffer.jsonl', zbuffer],
    ['packed.jsonl.gz', (): Buffer => gzipSync(warnock())],
  ])('%s opens quickly, and so does any step of it', async (name, content) => {
    const { page, faults } = await open(browser, '#lang=en');
    const opening = await openingOf(page, name, content());
    const { state, shown } = await seeks(page);
    const megabytes = await memory(page);
    console.log(
      `${name}: first picture ${opening.first.toFixed()} ms, whole ${opening.whole.toFixed()} ms; ` +
        `99 of 100 seeks ${at99(state).toFixed(1)} ms, shown ${at99(shown).toFixed(1)} ms; ` +
        `${megabytes.toFixed()} MB`,
    );
    // A busy machine takes many times as long. This limit only catches gross failures.
    expect(opening.first).toBeLessThan(10_000);
    expect(opening.whole).toBeLessThan(30_000);
    expect(opening.growing).toBeGreaterThan(1);
    expect(at99(state)).toBeLessThan(500);
    expect(at99(shown)).toBeLessThan(1000);
    expect(megabytes).toBeLessThan(400);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it('may be stepped through while it is read, and stays at the current step', async () => {
    const name = 'growing.jsonl';
    const { page } = await open(browser, '#lang=en');
    await openFile(page, name, warnock());
    await isOpen(page, name);
    for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
    expect((await shown(page)).step).toBe(3);
    expect(await page.locator('vidno-notice .growing').textContent()).toMatch(
      /^Reading: [\d,]+ steps so far, \d+% of the file$/,
    );
    await whole(page);
    const { step, length } = await shown(page);
    expect(step).toBe(3);
    expect(length).toBeGreaterThan(events);
    await page.keyboard.press('End');
    expect((await shown(page)).step).toBe(length);
  });
});
