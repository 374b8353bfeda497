import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser, settled } from './browser.js';
import { sentences, stepsOf } from './compare.js';
import { editing, handle, openScene } from './live.js';
import { goTo, open, openUrl, shown, whole } from './page.js';

/** N, a near square of 8 x 8 pixels, in the middle of Q, a far quad over the whole area. */
const warnock = 'trace=09-usual-mistakes.warnock.double.corrected.signs';

const result = (page: Page): Promise<string | null> =>
  page.locator('vidno-broken-line .result').textContent();
const title = (page: Page): Promise<string> =>
  page
    .locator('vidno-broken-line h2')
    .evaluate((heading) => heading.textContent.replace(/\s+/gu, ' ').trim());

async function openRun(hash: string): Promise<{ page: Page; faults: readonly string[] }> {
  const opened = await open(browser, `#lang=en&${hash}`);
  await opened.page.locator('.title h2', { hasText: /./u }).waitFor();
  await whole(opened.page);
  return opened;
}

/** Breaks a line by its mark, and waits for the result. */
async function breakLine(page: Page, at: string, edition: string): Promise<void> {
  const line = page.locator('vidno-listing li', {
    has: page.locator(`.at:text-matches("^${at}")`),
  });
  await line.first().locator('.mark').click();
  await page.locator(`vidno-wrong-lines dialog[open] button[name="${edition}"]`).click();
  await known(page);
}

async function known(page: Page): Promise<void> {
  await page.locator('vidno-broken-line .result', { hasNotText: /searching|поиск/u }).waitFor();
  await page.locator('vidno-broken-line button[name=first]').waitFor();
}

/** The centres of the cells in a small picture that are not faint. */
const changed = (page: Page, which: 'right' | 'wrong'): Promise<readonly string[]> =>
  page.locator(`vidno-broken-line canvas.${which}`).evaluate((element) => {
    const shown = element as HTMLCanvasElement;
    const canvas = new OffscreenCanvas(shown.width, shown.height);
    const context = canvas.getContext('2d', { willReadFrequently: true });
    context?.drawImage(shown, 0, 0);
    const colors: string[] = [];
    for (let j = 0; j < 16; j++) {
      for (let i = 0; i < 16; i++) {
        const [x, y] = [(i + 0.5) / 16, (j + 0.5) / 16];
        const at = [Math.floor(x * canvas.width), Math.floor(y * canvas.height)] as const;
        const [r, g, b] = context?.getImageData(...at, 1, 1).data ?? [];
        colors.push([r, g, b].join());
      }
    }
    return colors.filter((color) => color !== '222,226,230');
  });

describe('a broken line of the listing', () => {
  it('as printed runs beside the corrected one, at the first difference', async () => {
    const { page, faults } = await openRun(`${warnock}&step=5`);
    await breakLine(page, 'PW7', 'printed:x-w3');
    expect(await title(page)).toBe('Broken: PW7 X-W3');
    // Two planes, push, pop, call, corners, box, count, four depths, four comparisons, nearer: then k = 4, so that PW7 uncovers;
    // with X-W3 only 0 < k < 4 would.
    await expect.poll(() => stepsOf(page)).toEqual([18, 18]);
    expect(await sentences(page)).toEqual(['PW7', 'PW8']);
    // Q stays visible: all of N is lost.
    expect(await result(page)).toBe('Pixels that change: 64 of 256.');
    const [right, wrong] = [await changed(page, 'right'), await changed(page, 'wrong')];
    expect([right.length, wrong.length]).toEqual([64, 64]);
    expect(new Set(right).size).toBe(1);
    expect(new Set(wrong)).not.toEqual(new Set(right));
    await page.getByRole('button', { name: 'Back to the correct run' }).click();
    await page.locator('vidno-comparison').waitFor({ state: 'detached' });
    expect((await shown(page)).step).toBe(5);
    await page.waitForURL((url) => !/with=|layer=/u.test(url.href));
    expect(faults).toEqual([]);
  });

  it('with a usual mistake does, too', async () => {
    const { page, faults } = await openRun(warnock);
    await breakLine(page, 'PW1', 'printed:x-w2');
    // All depths are above 0, so every window is decided as before. The corners start at 0 in step 6.
    expect(await result(page)).toBe('The picture stays the same; only the steps differ.');
    await expect.poll(() => stepsOf(page)).toEqual([6, 6]);
    expect(await sentences(page)).toEqual(['PW1', 'PW1']);
    // Another line of the right run is broken from here.
    await breakLine(page, 'W13', 'one-list');
    expect(await title(page)).toBe('Broken: W13 one list for all parts');
    // Q is in all windows and N is disjoint from some. N leaves the one list there, and is lost.
    expect(await result(page)).toBe('Pixels that change: 64 of 256.');
    await expect.poll(() => sentences(page)).toEqual(['W13', 'W13']);
    expect(faults).toEqual([]);
  });

  it('shows the smallest scene, goes back to the scene, and to the correct run', async () => {
    const { page, faults } = await openRun(`${warnock}&step=7`);
    await breakLine(page, 'D1', 'depth-sign-reversed');
    await page.getByRole('button', { name: 'Smallest scene that shows it' }).click();
    await page.locator('vidno-broken-line button[name=own]').waitFor();
    await expect.poll(() => result(page)).toBe('Pixels that change: 1 of 1.');
    await expect.poll(() => sentences(page)).toEqual(['PW5', 'PW5']);
    await page.waitForURL(/witness=[1-9]/u);
    // The witness is part of the link.
    const link = page.url();
    const other = await openUrl(browser, link);
    await other.page.locator('vidno-broken-line button[name=own]').waitFor();
    expect(await stepsOf(other.page)).toEqual(await stepsOf(page));
    expect(other.faults).toEqual([]);
    await page.getByRole('button', { name: 'Back to the scene' }).click();
    await expect.poll(() => result(page)).toMatch(/^Pixels that change: \d+ of 256\.$/u);
    await page.getByRole('button', { name: 'Back to the correct run' }).click();
    await page.locator('vidno-comparison').waitFor({ state: 'detached' });
    expect((await shown(page)).step).toBe(7);
    expect(faults).toEqual([]);
  });

  it('is undone by Back, step by step', async () => {
    const { page, faults } = await openRun(`${warnock}&step=7`);
    await settled(page);
    await breakLine(page, 'D1', 'depth-sign-reversed');
    await expect.poll(async () => (await stepsOf(page))[0]).toBeGreaterThan(7);
    const found = await stepsOf(page);
    await settled(page);
    await page.getByRole('button', { name: 'Smallest scene that shows it' }).click();
    await expect.poll(() => result(page)).toBe('Pixels that change: 1 of 1.');
    await expect.poll(() => sentences(page)).toEqual(['PW5', 'PW5']);
    const seen = await stepsOf(page);
    await settled(page);
    await page.keyboard.press('End');
    await settled(page);

    await page.goBack();
    await expect.poll(() => stepsOf(page)).toEqual(seen);
    await settled(page);
    await page.goBack();
    await expect.poll(() => result(page)).toMatch(/^Pixels that change: \d+ of 256\.$/u);
    expect(await stepsOf(page)).toEqual(found);
    await settled(page);
    await page.goBack();
    await page.locator('vidno-comparison').waitFor({ state: 'detached' });
    expect((await shown(page)).step).toBe(7);
    await settled(page);
    await page.goForward();
    await expect.poll(() => stepsOf(page)).toEqual(found);
    expect(faults).toEqual([]);
  });

  it('has both pictures and sentences in sight, also on a projector', async () => {
    const { page, faults } = await openRun(warnock);
    await breakLine(page, 'D1', 'depth-sign-reversed');
    for (const presenting of [false, true]) {
      if (presenting) await page.keyboard.press('f');
      for (const [width, height] of [
        [1920, 1080],
        [1440, 900],
        [1366, 768],
        [1280, 720],
        [1024, 768],
      ] as const) {
        await page.setViewportSize({ width, height });
        await settled(page);
        const dock = await page.locator('vidno-comparison .dock').boundingBox();
        const ends = await page
          .locator('vidno-compared-run :is(.picture, .picture canvas, .sentence)')
          .evaluateAll((parts) => parts.map((part) => part.getBoundingClientRect().bottom));
        const where = `${width} x ${height}${presenting ? ', presenting' : ''}`;
        expect(Math.max(...ends), where).toBeLessThanOrEqual(dock?.y ?? 0);
      }
    }
    expect(faults).toEqual([]);
  });

  it('is chosen, followed and repaired by keyboard alone', async () => {
    const { page, faults } = await openRun(warnock);
    await page.locator('vidno-listing .procedures').focus();
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Enter');
    const focused = page.locator('vidno-wrong-lines button:focus');
    await focused.waitFor();
    const names: (string | null)[] = [];
    for (let i = 0; i < 3; i++) {
      names.push(await focused.getAttribute('name'));
      await page.keyboard.press('ArrowDown');
    }
    expect(names).toEqual(['printed:x-w8', 'printed:x-w5', 'integer-division']);
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowUp');
    expect(await focused.getAttribute('name')).toBe('printed:x-w5');
    await page.keyboard.press('Enter');
    await page.locator('vidno-broken-line .result', { hasNotText: /searching/u }).waitFor();
    // 16 x 16 is a square of a power of two, so its halves are integers either way.
    expect(await result(page)).toBe('On this scene the line makes no difference.');
    await page.locator('vidno-broken-line button[name=smallest]').focus();
    await page.keyboard.press('Enter');
    await page.locator('vidno-broken-line button[name=own]').waitFor();
    await page.keyboard.press('d');
    await page.locator('vidno-comparison').waitFor({ state: 'detached' });
    expect(faults).toEqual([]);
  });

  it('runs again as a corner of the edited scene moves', async () => {
    const { page, faults } = await editing(browser);
    await breakLine(page, 'D1', 'depth-sign-reversed');
    expect(await result(page)).toMatch(/^Pixels that change: \d+ of 64\.$/u);
    await page.keyboard.press('e');
    await page.locator(handle(0, 0)).first().focus();
    await page.keyboard.press('ArrowRight');
    // Both runs have the corner, which has moved a quarter of a pixel to the right from x = 1.
    const corners = (): Promise<unknown> =>
      page.evaluate(() => {
        const app = document.querySelector('vidno-app')?.shadowRoot;
        const pair = app?.querySelector('vidno-comparison');
        return [pair?.trace, pair?.rival].map((run) => [
          run?.header.edition,
          run?.header.scene.polygons[0]?.vertices[0]?.[0],
        ]);
      });
    await expect.poll(corners).toEqual([
      ['corrected', 1.25],
      ['depth-sign-reversed', 1.25],
    ]);
    await known(page);
    expect(faults).toEqual([]);
  });

  it('is offered at the lines of the Z-buffer and of the floating horizon', async () => {
    const { page, faults } = await openRun(
      'trace=09-usual-mistakes.zbuffer.double.corrected.signs',
    );
    await breakLine(page, 'Z1', 'depths-not-cleared');
    expect(await title(page)).toBe('Broken: Z1 Z not cleared');
    await page.getByRole('button', { name: 'Back to the correct run' }).click();
    await page.locator('vidno-comparison').waitFor({ state: 'detached' });
    const curves = JSON.stringify({
      format: 'vidno-surface/1',
      name: 'A line below another',
      window: { x: 0, y: 0, width: 4, height: 5 },
      curves: [
        [
          [0, 1],
          [3, 1],
        ],
        [
          [0, 2],
          [3, 2],
        ],
      ],
    });
    await openScene(page, curves);
    await breakLine(page, 'FH6', 'printed:x-h1');
    // The second line lies below the first over all four columns, and is not drawn.
    expect(await result(page)).toBe('Columns over which curves change: 4.');
    expect(faults).toEqual([]);
  });

  it('is not offered for the printed edition', async () => {
    const { page } = await openRun(warnock);
    expect(await page.locator('vidno-listing .mark').count()).toBeGreaterThan(5);
    await page.locator('vidno-page-header').waitFor();
    const { page: printed } = await openRun('trace=09-usual-mistakes.warnock.double.printed.signs');
    expect(await printed.locator('vidno-listing .mark').count()).toBe(0);
    expect(await printed.locator('vidno-listing .break').count()).toBe(0);
  });

  it('is described in Russian, and to screen readers', async () => {
    const { page } = await openRun(warnock);
    await breakLine(page, 'PW7', 'surround-kept');
    expect(await violations(page)).toEqual([]);
    await page.goto(page.url().replace('lang=en', 'lang=ru'));
    await known(page);
    expect(await result(page)).toBe('Меняются пиксели: 64 из 256.');
    expect(await page.locator('vidno-broken-line .says').textContent()).toContain(
      'hasSurround никогда не сбрасывается',
    );
    await goTo(page, 1);
  });
});
