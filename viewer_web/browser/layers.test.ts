import type { Page } from 'playwright-core';
import type { Frame } from '../src/picture/frame.js';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser, settled } from './browser.js';
import { openScene, run, scene, shapes, square, title, triangle } from './live.js';
import { goTo, open, shown, whole } from './page.js';
import { scaleOf } from './zoom.js';
import type { Opened } from './page.js';

const printed = (method: string): string => `09-usual-mistakes.${method}.double.printed.signs`;

async function openLesson(
  trace: string,
  options: Parameters<typeof open>[2] = {},
  hash = '',
): Promise<Opened> {
  const found = await open(browser, `#lang=en&trace=${trace}&view=workbench${hash}`, options);
  await found.page.locator(title, { hasText: /./u }).waitFor();
  await whole(found.page);
  return found;
}

const choice = (page: Page) => page.locator('vidno-layers select');
const status = (page: Page) => page.locator('vidno-layers .status');
const image = (page: Page): Promise<string> =>
  page
    .locator('vidno-picture .cells')
    .evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
/** The picture's box in page coordinates, independent of scrolling. */
const box = (page: Page) =>
  page.locator('vidno-picture').evaluate((picture) => {
    const { x, y, width, height } = picture.getBoundingClientRect();
    return [x + scrollX, y + scrollY, width, height];
  });

describe('the choice of a layer', () => {
  it.each([390, 1280, 1920])(
    'and what it says stand below the picture, in its panel, at %d px',
    async (width) => {
      const viewport = { width, height: width < 500 ? 844 : 800 };
      const { page } = await openLesson(printed('zbuffer'), { viewport }, '&reader=off');
      await choice(page).selectOption('difference');
      await expect.poll(() => status(page).textContent()).toContain('wrong');
      const picture = await page.locator('vidno-picture').boundingBox();
      const panel = await page.locator('section.picture').boundingBox();
      if (picture === null || panel === null) throw new Error('no picture');
      for (const part of [
        choice(page),
        status(page),
        page.locator('vidno-legend button').first(),
      ]) {
        const found = (await part.boundingBox()) ?? { x: NaN, y: NaN, width: NaN, height: NaN };
        expect(found.y).toBeGreaterThanOrEqual(picture.y + picture.height - 1);
        expect(found.y + found.height).toBeLessThanOrEqual(panel.y + panel.height);
        expect(found.x).toBeGreaterThanOrEqual(panel.x);
        expect(found.x + found.width).toBeLessThanOrEqual(panel.x + panel.width);
      }
    },
  );
});

describe('the difference', () => {
  it.each([
    // All 64 pixels of N are lost: the defect X-W3 of the printed text.
    ['warnock', 64],
    // Rows and columns 4 to 12 are painted, both ends included (X-Z3, X-Z5). Rows and columns 4 to 11 are right: 9 x 9 - 8
    // x 8.
    ['zbuffer', 17],
  ])('of the printed text by %s is %d wrong pixels', async (method, wrong) => {
    const { page, faults } = await openLesson(printed(method));
    await page.keyboard.press('End');
    await choice(page).selectOption('difference');
    await expect.poll(() => status(page).textContent()).toContain(`${wrong} with a wrong colour`);
    expect(await status(page).textContent()).toContain('0 not painted yet');
    expect(faults).toEqual([]);
  });

  it('falls as the run goes on', async () => {
    const { page } = await openLesson(
      '09-usual-mistakes.warnock.double.corrected.signs',
      {},
      '&layer=difference',
    );
    await page.keyboard.press('Home');
    await expect.poll(() => status(page).textContent()).toContain('256 not painted yet');
    await page.keyboard.press('End');
    await expect.poll(() => status(page).textContent()).toContain('0 not painted yet');
    expect(await status(page).textContent()).toContain('0 with a wrong colour');
  });
});

describe('the exact picture', () => {
  it('is shown before the first step, and equals the end of a right run', async () => {
    const { page, faults } = await openLesson('03-subdivision.warnock.double.corrected.signs');
    await page.keyboard.press('End');
    const last = await image(page);
    await page.keyboard.press('Home');
    expect(await image(page)).not.toBe(last);
    await choice(page).selectOption('exact');
    await expect.poll(() => image(page)).toBe(last);
    expect(faults).toEqual([]);
  });

  it('follows a scene that is edited', async () => {
    const { page } = await open(browser, '#lang=en&layer=difference');
    await openScene(page, scene([square]));
    // The square is 5 x 5 pixels.
    await page.keyboard.press('Home');
    await expect.poll(() => status(page).textContent()).toContain('25 not painted yet');
    await openScene(page, scene([triangle, square]));
    await page.keyboard.press('End');
    await expect.poll(() => status(page).textContent()).toContain('0 not painted yet');
    expect(await status(page).textContent()).toContain('0 with a wrong colour');
  });
});

describe('the choice of a layer', () => {
  it('cycles with L, is announced, and is kept in the link', async () => {
    const { page } = await openLesson('08-show-line.zbuffer.float.corrected.signs');
    expect(await choice(page).inputValue()).toBe('picture');
    const seen: string[] = [];
    for (let i = 0; i < 4; i++) {
      await page.keyboard.press('l');
      await expect.poll(() => choice(page).inputValue()).not.toBe(seen.at(-1) ?? 'picture');
      seen.push(await choice(page).inputValue());
    }
    expect(seen).toEqual(['depths', 'exact', 'difference', 'picture']);
    await page.keyboard.press('l');
    await expect
      .poll(() => page.locator('vidno-layers [aria-live]').textContent())
      .toMatch(/^Depths: /);
    await page.waitForURL(/layer=depths/);
    const again = await open(browser, new URL(page.url()).hash);
    await again.page.locator(title, { hasText: /./u }).waitFor();
    expect(await choice(again.page).inputValue()).toBe('depths');
  });

  it('has no depths where the trace has none', async () => {
    const { page } = await openLesson(printed('warnock'), {}, '&layer=depths');
    const names = await choice(page)
      .locator('option')
      .evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value));
    expect(names).toEqual(['picture', 'exact', 'difference']);
    expect(await choice(page).inputValue()).toBe('picture');
  });

  it.each([
    [390, 'RU'],
    [1280, 'RU'],
    [1280, 'EN'],
  ])('moves and cuts off nothing at %d px in %s', async (width, language) => {
    const trace = '08-show-line.zbuffer.float.corrected.signs';
    // A narrow player fits beside the text. On a phone only one of the two is shown.
    const reader = width < 500 ? '&reader=off' : '';
    const { page } = await openLesson(trace, { viewport: { width, height: 800 } }, reader);
    if (language === 'RU') await page.locator('vidno-languages [lang=ru]').click();
    const before = await box(page);
    for (const layer of ['depths', 'exact', 'difference']) {
      await choice(page).selectOption(layer);
      for (const step of [0, 300, 900]) {
        await goTo(page, step);
        expect((await shown(page)).step).toBe(step);
        expect(await box(page)).toEqual(before);
        const { scrollWidth, clientWidth, scrollHeight, clientHeight } = await status(
          page,
        ).evaluate((element) => ({
          scrollWidth: element.scrollWidth,
          clientWidth: element.clientWidth,
          scrollHeight: element.scrollHeight,
          clientHeight: element.clientHeight,
        }));
        expect(scrollWidth).toBeLessThanOrEqual(clientWidth);
        expect(scrollHeight).toBeLessThanOrEqual(clientHeight);
      }
    }
  });

  it('can be used by all (WCAG 2.2 AA)', async () => {
    const { page } = await openLesson('08-show-line.zbuffer.float.corrected.signs');
    for (const layer of ['depths', 'difference']) {
      await choice(page).selectOption(layer);
      expect(await violations(page)).toEqual([]);
    }
  });
});

describe('the windows so far', () => {
  it('are drawn, and so are those that enclose the current one', async () => {
    const { page } = await openLesson('09-usual-mistakes.warnock.double.corrected.signs');
    const lines = async (role: string): Promise<string | undefined> =>
      (await shapes(page)).find(({ look }) => look === role)?.d;
    // Goes to the first window of 8 x 8. The quarters of 16 x 16 are drawn, and only the whole area encloses this one.
    const quarter = await page.evaluate(() => {
      const app = document.querySelector('vidno-app');
      const timeline = app?.shadowRoot?.querySelector('vidno-player')?.trace?.timeline;
      let step = 1;
      while (!/^\{"e":"pop".*,8,8\]/.test(timeline?.line(step) ?? '{"e":"pop",8,8]')) step++;
      return step;
    });
    await goTo(page, quarter);
    expect(await lines('tree')).toBe('M0 0H16M0 8H16M0 16H16M0 0V16M8 0V16M16 0V16');
    expect(await lines('way')).toBe('M0 0H16M0 16H16M0 0V16M16 0V16');
  });

  it('are ink on the picture, dark on a light casing', async () => {
    const { page } = await openLesson('09-usual-mistakes.warnock.double.corrected.signs');
    // Goes to the step that pops the first window, the whole area of 16 x 16.
    const { lines } = await run(page);
    await goTo(page, lines.findIndex((line) => line.startsWith('{"e":"pop"')) + 1);
    await settled(page);
    const color = (x: number, y: number): Promise<readonly number[]> =>
      page.locator('vidno-picture').evaluate(
        (picture, [across, down]) => {
          const { frame } = picture as unknown as { frame: Frame };
          const canvas = picture.shadowRoot?.querySelector<HTMLCanvasElement>('.step');
          const [left, top] = frame.shown;
          const dot = canvas
            ?.getContext('2d')
            ?.getImageData((across - left) * frame.scale, (down - top) * frame.scale, 1, 1);
          return [...(dot?.data ?? [])];
        },
        [x, y] as const,
      );
    expect(await color(0, 8)).toEqual([0x10, 0x13, 0x1c, 255]);
    const pixel = 1 / (await scaleOf(page));
    // The casing is 2.5 pixels wide on each side and the ink on it 1.5. One of these dots has casing and no ink.
    const beside = await Promise.all([2, 2.25, 2.5].map((n) => color(n * pixel, 8)));
    const light = beside.map(([r = 0, g = 0, b = 0, a = 0]) => (a > 0 ? Math.min(r, g, b) : 0));
    expect(Math.max(...light)).toBeGreaterThan(200);
    expect(await color(8, 8)).toEqual([0, 0, 0, 0]);
  });
});
