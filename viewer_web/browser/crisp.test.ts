import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { rerun, scene, square, title } from './live.js';
import { open, openFile } from './page.js';
import { scaleOf, stage, wheel } from './zoom.js';

/** Where on the canvas colours change along the line through the middle of the box, in its dots. */
const edgesOn = (page: Page, way: 'across' | 'down'): Promise<readonly number[]> =>
  page.locator('vidno-picture > canvas').evaluate((element, along) => {
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

/** Where the grid's lines are from the corner of the canvas, in dots of the device. */
const linesOn = (page: Page, way: 'across' | 'down', ratio: number): Promise<readonly number[]> =>
  page.locator(stage).evaluate(
    (element, [along, dots]) => {
      const svg = element as SVGSVGElement;
      const matrix = svg.getScreenCTM();
      const { left, top } = svg.getBoundingClientRect();
      const path = svg.querySelector('.grid')?.getAttribute('d') ?? '';
      const ends = [...path.matchAll(/M(-?\d+) (-?\d+)([vh])/g)];
      return ends
        .filter(([, , , kind]) => kind === (along === 'across' ? 'v' : 'h'))
        .map(([, x, y]) => new DOMPoint(Number(x), Number(y)).matrixTransform(matrix ?? undefined))
        .map((at) => (along === 'across' ? at.x - left : at.y - top) * dots);
    },
    [way, ratio] as const,
  );

const cases = [1, 2].flatMap((ratio) => [1, 3.7, 20].map((zoom) => [zoom, ratio] as const));

describe('the canvas and the grid agree to half a dot of the device', () => {
  it.each(cases)('at zoom %d, %d dots a CSS pixel', async (zoom, ratio) => {
    const { page } = await open(browser, '#lang=en', { deviceScaleFactor: ratio });
    await page.locator(title, { hasText: /./u }).waitFor();
    await rerun(page, () => openFile(page, 'square.json', scene([square])));
    await page.keyboard.press('End');
    const fit = await scaleOf(page);
    // About a corner of the square, so that there are edges in sight.
    if (zoom > 1) await wheel(page, 2, 2, zoom);
    expect((await scaleOf(page)) / fit).toBeCloseTo(zoom, 3);
    const found = await Promise.all([edgesOn(page, 'across'), edgesOn(page, 'down')]);
    expect(found.flat().length).toBeGreaterThan(0);
    for (const [i, way] of (['across', 'down'] as const).entries()) {
      const lines = await linesOn(page, way, ratio);
      for (const edge of found[i] ?? []) {
        expect(Math.min(...lines.map((line) => Math.abs(line - edge)))).toBeLessThanOrEqual(0.501);
      }
    }
  });
});
