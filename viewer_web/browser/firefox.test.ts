import { pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';
import type { Browser, Page } from 'puppeteer-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { built } from './browser.js';

/** The page in Firefox ESR, opened from disk: the most common actions, without any complaint of the browser. */
let firefox: Browser;
beforeAll(async () => {
  firefox = await puppeteer.launch({
    browser: 'firefox',
    executablePath: process.env['FIREFOX'] ?? '/usr/bin/firefox-esr',
    headless: true,
  });
});
afterAll(() => firefox.close());

async function open(hash: string): Promise<{ page: Page; faults: readonly string[] }> {
  const page = await firefox.newPage();
  await page.setViewport({ width: 1440, height: 900 });
  const faults: string[] = [];
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('console', (message) => {
    if (['error', 'warn'].includes(message.type())) faults.push(message.text());
  });
  await page.goto(pathToFileURL(built).href + hash);
  await page.waitForFunction(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    return player?.trace?.complete === true;
  });
  return { page, faults };
}

interface Shown {
  readonly step: number;
  readonly length: number;
  readonly sentence: string;
  /** The label of the event, and that of the marked line of the listing. */
  readonly at: string | null;
  readonly line: string | null;
  readonly state: string;
  readonly vertex: readonly number[];
}

const shown = (page: Page): Promise<Shown> =>
  page.evaluate(async () => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    if (!player?.trace) throw new Error('no run');
    await player.updateComplete;
    const { step, length, trace, shadowRoot: root } = player;
    const listing = root?.querySelector('vidno-listing');
    await listing?.updateComplete;
    return {
      step,
      length,
      sentence: root?.querySelector('.sentence')?.textContent.replace(/\s+/gu, ' ').trim() ?? '',
      at: trace.timeline.event(step)?.at ?? null,
      line: listing?.shadowRoot?.querySelector('[aria-current] .at')?.textContent ?? null,
      state: JSON.stringify(trace.timeline.valuesAt(step)),
      vertex: trace.header.scene.polygons[0]?.vertices[0]?.slice() ?? [],
    };
  });

/** The place on the page of a point of the scene's plane. */
const spotOf = (page: Page, x: number, y: number): Promise<{ x: number; y: number }> =>
  page.$eval(
    '>>> vidno-picture >>>> svg',
    (stage, atX, atY) => {
      const matrix = stage.getScreenCTM() ?? new DOMMatrix();
      const { x: left, y: top } = new DOMPoint(atX, atY).matrixTransform(matrix);
      return { x: left, y: top };
    },
    x,
    y,
  );

async function seek(page: Page, step: number): Promise<void> {
  const field = await page.waitForSelector('>>> .step input[type=number]');
  await field?.click({ count: 3 });
  await field?.type(String(step));
  await field?.press('Enter');
  await field?.evaluate((input) => (input as HTMLElement).blur());
}

describe('in Firefox', () => {
  it('the page opens on a finished run, which the library compares with the exact picture', async () => {
    const { page, faults } = await open('#lang=en');
    const { step, length } = await shown(page);
    expect(length).toBeGreaterThan(100);
    expect(step).toBe(length);
    // This is said only of a run whose pixels are all as in exact arithmetic.
    await page.waitForSelector('>>> .welcome ::-p-text(the nearest is visible)');
    expect(faults).toEqual([]);
    await page.close();
  });

  it('stepping by keys reaches the same state as a step’s number', async () => {
    const { page, faults } = await open('#lang=en&step=40&view=workbench');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    const stepped = await shown(page);
    expect(stepped.step).toBe(42);
    expect(stepped.line).toBe(stepped.at);
    expect(stepped.sentence).toContain(stepped.at);
    await page.keyboard.press('Home');
    expect((await shown(page)).step).toBe(0);
    await seek(page, 42);
    expect(await shown(page)).toEqual(stepped);
    expect(faults).toEqual([]);
    await page.close();
  });

  it('a corner that is dragged is followed by its run', async () => {
    const { page, faults } = await open('#lang=en&view=workbench');
    const before = await shown(page);
    const [x = 0, y = 0] = before.vertex;
    await page.keyboard.press('e');
    await page.waitForSelector('>>> vidno-handles >>> [data-spot="0,0"]');
    const [from, to] = [await spotOf(page, x, y), await spotOf(page, x + 1.5, y + 0.75)];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2);
    await page.mouse.move(to.x, to.y);
    await page.mouse.up();
    // Corners lie on quarters of a pixel.
    await expect
      .poll(async () => (await shown(page)).vertex.slice(0, 2))
      .toEqual([x + 1.5, y + 0.75]);
    await page.keyboard.down('Control');
    await page.keyboard.press('z');
    await page.keyboard.up('Control');
    await expect.poll(async () => (await shown(page)).vertex).toEqual(before.vertex);
    expect(faults).toEqual([]);
    await page.close();
  });
});
