import { describe, expect, it } from 'vitest';
import { toPixel } from '../replay/screen.js';
import { headerOf, textOf, textWith, traceOf, parseHeader } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { cellsOf, depthRange, differenceOf, layersOf } from './layers.js';
import { opaque } from './paint.js';
import type { Cells } from './paint.js';
import { inkAt } from './ramp.js';

const fill = (x: number, width: number, color: string): Event => ({
  e: 'fill',
  at: 'W8',
  rect: [x, 0, width, 8],
  color,
});

async function screenAfter(...events: readonly Event[]) {
  const { timeline } = await traceOf(textWith(headerOf('warnock'), events));
  return timeline.seek(events.length).screen;
}

/** All cells of a row. */
const rowOf = (cells: Cells | null, j: number): ArrayLike<number> =>
  cells?.row(j, [...Array(cells.width).keys()]) ?? [];

describe('the difference', () => {
  it('counts wrong pixels, and background pixels still to be painted', async () => {
    // 8 columns: 0 to 2 are right, 3 and 4 wrong, 5 and 6 not yet painted, and 7 is background in the end.
    const exact = await screenAfter(fill(0, 7, '#112233'));
    const { picture } = await screenAfter(fill(0, 3, '#112233'), fill(3, 2, '#445566'));
    expect(differenceOf(picture, exact.picture)).toEqual({ wrong: 2 * 8, lacking: 2 * 8 });
  });

  it('is wrong where a pixel was painted in the background colour', async () => {
    const exact = await screenAfter(fill(0, 8, '#112233'));
    const { picture } = await screenAfter(fill(0, 1, '#ffffff'));
    expect(differenceOf(picture, exact.picture)).toEqual({ wrong: 8, lacking: 7 * 8 });
  });

  it('distinguishes the three by texture, and pales the colours', async () => {
    const exact = await screenAfter(fill(0, 2, '#112233'));
    const screen = await screenAfter(fill(0, 1, '#112233'), fill(2, 1, '#445566'));
    const row = rowOf(cellsOf('difference', screen, exact.picture), 0);
    const textures = Array.from(row, (cell) => cell >>> 24);
    const [right, lacking, wrong, ground] = textures;
    expect(new Set([right, lacking, wrong]).size).toBe(3);
    expect(ground).toBe(right);
    // 170 plus a third of 11, 22 and 33 (hexadecimal).
    expect(row[0]).toBe(toPixel('#b0b5bb'));
  });
});

describe('the depths', () => {
  it('range from the farthest to the nearest vertex; an unpainted pixel has none', async () => {
    const { header, timeline } = await traceOf(textOf('small.zbuffer.signs.jsonl'));
    const { scene } = header;
    const depths = scene.polygons.flatMap(({ vertices }) => vertices.map(([, , z]) => z));
    expect(depthRange(scene)).toEqual([Math.min(...depths), Math.max(...depths)]);
    const { screen } = timeline.seek(timeline.length);
    const cells = cellsOf('depths', screen, null);
    const near = Math.max(...depths);
    const far = Math.min(...depths);
    for (let j = 0; j < screen.picture.height; j++) {
      const inks = rowOf(cells, j);
      for (let i = 0; i < screen.picture.width; i++) {
        const [z, ink = NaN] = [screen.z?.at(i, j), inks[i]];
        if (z === '-inf') expect(ink).not.toBe(opaque(ink));
        else expect(ink).toBe(inkAt((Number(z) - far) / (near - far)));
      }
    }
  });
});

describe('the layers of a trace', () => {
  it('are those that it has', () => {
    const of = (method: 'warnock' | 'zbuffer', detail: 'windows' | 'signs') =>
      parseHeader(headerOf(method, detail));
    expect(layersOf(of('warnock', 'signs'), null)).toEqual(['picture']);
    expect(layersOf(of('zbuffer', 'windows'), null)).toEqual(['picture']);
    expect(layersOf(of('zbuffer', 'signs'), 'computing')).toEqual([
      'picture',
      'depths',
      'exact',
      'difference',
    ]);
  });
});

describe('the picture so far', () => {
  it('is the background where nothing was painted', async () => {
    const screen = await screenAfter(fill(0, 1, '#112233'));
    expect(screen.picture.row(0)[1]).toBe(0xffffff);
    const row = rowOf(cellsOf('picture', screen, null), 0);
    expect([row[0], row[1]]).toEqual([toPixel('#112233'), toPixel('#ffffff')]);
  });
});
