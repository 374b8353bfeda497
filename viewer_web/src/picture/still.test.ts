import { describe, expect, it } from 'vitest';
import type { Scene } from '../trace/header.js';
import { Frame } from './frame.js';
import { toPixel } from '../replay/screen.js';
import type { Pixels } from '../replay/screen.js';
import { labelsOf } from './still.js';

const area = { x: 0, y: 0, width: 8, height: 8 };
const frame = new Frame(area, { width: 320, height: 320 });

const sceneOf = (id: string): Scene => ({
  name: '',
  area,
  background: '#ffffff',
  polygons: [{ id, color: '#000000', vertices: [[1, 1, 0]] }],
  byId: new Map(),
  curves: null,
});

describe('the name of a polygon', () => {
  it('is in the picture unchanged', () => {
    expect(labelsOf(sceneOf('roof'), frame)[0]).toMatchObject({ text: 'roof', of: 'roof' });
  });

  it('is shortened where it would cross the picture, and still belongs to its polygon', () => {
    const long = 'я'.repeat(5000);
    const [label] = labelsOf(sceneOf(long), frame);
    expect(label?.text).toBe(`${'я'.repeat(31)}…`);
    expect(label?.of).toBe(long);
  });

  it('lies in the picture even if its first vertex is at the edge', () => {
    const name = 'ABCDEFGHIJKLMNOPQRST';
    const [label] = labelsOf(sceneOf(name), frame);
    // 20 letters of 8 CSS pixels and a swatch of 12 at 35 CSS pixels per unit need 2.5 units on each side of the middle; the
    // picture begins at -0.56.
    expect(label?.at[0]).toBeCloseTo(-0.56 + 2.5, 1);
    expect(label?.at[1]).toBe(1);
  });
});

/** A picture of 8 x 8 pixels: those in some columns are red, the others blue. */
const picture = (isRed: (column: number) => boolean): Pixels => {
  const at = (i: number): number => toPixel(isRed(i) ? '#ff0000' : '#0000ff');
  return {
    ...{ width: 8, height: 8, version: '', at },
    row: () => Uint32Array.from({ length: 8 }, (_, i) => at(i)),
    repeats: () => false,
  };
};

describe('the names of two polygons that both cover the area', () => {
  const square = [
    [0, 0, 0],
    [8, 0, 0],
    [8, 8, 0],
    [0, 8, 0],
  ] as const;
  const scene: Scene = {
    ...sceneOf(''),
    polygons: [
      { id: 'R', color: '#ff0000', vertices: square },
      { id: 'B', color: '#0000ff', vertices: square },
    ],
  };
  const columns = (all: ReturnType<typeof labelsOf>) => all.map(({ at }) => Math.floor(at[0]));

  it('stand on pixels of their colours, each with its swatch', () => {
    const labels = labelsOf(
      scene,
      frame,
      picture((x) => x < 3),
    );
    const [red = NaN, blue = NaN] = columns(labels);
    expect(red).toBeLessThan(3);
    expect(blue).toBeGreaterThanOrEqual(3);
    expect(labels.map(({ color }) => color)).toEqual(['#ff0000', '#0000ff']);
  });

  it('stay where they are as long as the pixels there keep their colours', () => {
    const first = labelsOf(
      scene,
      frame,
      picture((x) => x < 3),
    );
    expect(
      labelsOf(
        scene,
        frame,
        picture((x) => x < 3),
        first,
      ),
    ).toBe(first);
    const [red = NaN] = columns(
      labelsOf(
        scene,
        frame,
        picture((x) => x >= 5),
        first,
      ),
    );
    expect(red).toBeGreaterThanOrEqual(5);
  });
});
