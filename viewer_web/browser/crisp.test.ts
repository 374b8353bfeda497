import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { openScene, scene, square } from './live.js';
import { open } from './page.js';
import { scaleOf, wheel } from './zoom.js';

/** The places on the canvas where colours change along the line through the middle of the box, in canvas pixels. */
const edgesOn = (page: Page, way: 'across' | 'down'): Promise<readonly number[]> =>
  page.locator('vidno-picture .cells').evaluate((element, along) => {
    const canvas = element as HTMLCanvasElement;
    const { width, height } = canvas;
    const context = canvas.getContext('2d');
    const image =
      along === 'across'
        ? context?.getImageData(0, height >> 1, width, 1)
        : context?.getImageData(width >> 1, 0, 1, height);
    const dots = [...new Uint32Array(image?.data.buffer ?? new ArrayBuffer(0))];
    return dots.flatMap((dot, i) => (i > 0 && dot !== dots[i - 1] ? [i] : []));
  }, way);

/** The centres of lines in canvas pixels, along a line that coincides with no other. */
const linesOn = (page: Page, way: 'across' | 'down'): Promise<readonly number[]> =>
  page.locator('vidno-picture .scene').evaluate((element, along) => {
    const { width, height } = element as HTMLCanvasElement;
    const context = (element as HTMLCanvasElement).getContext('2d');
    const data = context?.getImageData(0, 0, width, height).data ?? [];
    const [length, count] = along === 'across' ? [width, height] : [height, width];
    const inkOf = (i: number): readonly number[] =>
      Array.from({ length }, (_, at) => {
        const dot = along === 'across' ? i * width + at : at * width + i;
        return data[4 * dot + 3] ?? 0;
      });
    const sum = (ink: readonly number[]): number => ink.reduce((all, each) => all + each, 0);
    const near = Array.from({ length: count >> 1 }, (_, i) => inkOf((count >> 2) + i));
    const least = near.filter((ink) => sum(ink) > 0).sort((a, b) => sum(a) - sum(b))[0] ?? [];
    const lines: number[] = [];
    for (let at = 0, end = 0; at < length; at = end) {
      end = at + 1;
      if (least[at] === 0) continue;
      while (end < length && least[end] !== 0) end++;
      const line = least.slice(at, end);
      lines.push(line.reduce((all, ink, i) => all + ink * (at + i + 0.5), 0) / sum(line));
    }
    return lines;
  }, way);

/** The precision of a line's centre, computed from pixels with 256 levels. */
const read = 1 / 32;

const cases = [1, 2].flatMap((ratio) => [1, 3.7, 20].map((zoom) => [zoom, ratio] as const));

describe('the canvas and the grid agree to half a device pixel', () => {
  it.each(cases)('at zoom %d, %d device pixels per CSS pixel', async (zoom, ratio) => {
    const { page } = await open(browser, '#lang=en', { deviceScaleFactor: ratio });
    await openScene(page, scene([square]));
    await page.keyboard.press('End');
    const fit = await scaleOf(page);
    // Zooms around a corner of the square, so that edges are in sight.
    if (zoom > 1) await wheel(page, 2, 2, zoom);
    expect((await scaleOf(page)) / fit).toBeCloseTo(zoom, 3);
    const found = await Promise.all([edgesOn(page, 'across'), edgesOn(page, 'down')]);
    expect(found.flat().length).toBeGreaterThan(0);
    for (const [i, way] of (['across', 'down'] as const).entries()) {
      const lines = await linesOn(page, way);
      for (const edge of found[i] ?? []) {
        expect(Math.min(...lines.map((line) => Math.abs(line - edge)))).toBeLessThanOrEqual(
          0.501 + read,
        );
      }
    }
  });
});
