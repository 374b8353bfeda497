import { describe, expect, it } from 'vitest';
import { emptySketch } from '../run/sketch.js';
import { moveSample, surfaceText } from '../run/surface.js';
import { textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { headerOf } from '../trace/header.js';
import type { Curve } from '../trace/header.js';
import { curvesToPoint, heightOver, piecesOf } from './shapes.js';

/** A piece over the columns 1 and 3, a point between two gaps, and a piece over 6 and 7. */
const broken: Curve = [
  [0, null],
  [1, 2],
  [3, 4],
  [4, null],
  [5, 1],
  [6, null],
  [7, 3],
  [9, 3],
];
const away: Curve = [
  [0, null],
  [9, null],
];

const header = {
  ...{ format: 'vidno-trace/1', method: 'floating-horizon', edition: 'corrected' },
  ...{ kernel: 'double', detail: 'polygons' },
  scene: {
    format: 'vidno-surface/1',
    window: { x: 0, y: 0, width: 10, height: 8 },
    curves: [broken, away],
  },
};

describe('a curve with gaps', () => {
  it('has a piece for each run of neighbouring samples with points', () => {
    expect(piecesOf(broken)).toEqual([
      [
        [1, 2],
        [3, 4],
      ],
      [
        [7, 3],
        [9, 3],
      ],
    ]);
    expect(piecesOf(away)).toEqual([]);
  });

  it('is drawn in pieces, and has no height in a gap', () => {
    const shapes = curvesToPoint([broken, away]).map(({ d }) => d);
    expect(shapes[0]?.match(/M/gu)).toHaveLength(2);
    expect(shapes[1]).toBe('');
    expect(heightOver(broken, 2)).toBe(3);
    expect(heightOver(broken, 8)).toBe(3);
    expect([0, 4, 6, 10].map((column) => heightOver(broken, column))).toEqual([
      null,
      null,
      null,
      null,
    ]);
  });

  it('keeps its gaps when a sample is moved and the surface is written', () => {
    const sketch = { ...emptySketch, curves: [broken] };
    const moved = moveSample(sketch, [], { curve: 0, sample: 1 }, () => 7);
    expect(moved.curves?.[0]?.slice(0, 4)).toEqual([
      [0, null],
      [1, 7],
      [3, 4],
      [4, null],
    ]);
    expect(moveSample(sketch, [], { curve: 0, sample: 0 }, () => 7)).toBe(sketch);
    expect(JSON.parse(surfaceText(moved))).toMatchObject({ curves: moved.curves });
  });

  it('is read from the header of a trace', () => {
    expect(headerOf(JSON.stringify(header)).scene.curves).toEqual([broken, away]);
  });

  it('has no side edges where it has no piece', async () => {
    const events: readonly Event[] = [
      { e: 'curve', at: 'FH2', curve: 0 },
      { e: 'call', at: 'FH3', of: 'SideEdge' },
      { e: 'side_edge', at: 'FH3', sample: [1, 2] },
      { e: 'curve', at: 'FH2', curve: 1 },
    ];
    const { timeline } = await traceOf(textWith(header, events));
    const edges = (step: number): unknown => timeline.seek(step).values.floatingHorizon?.edges;
    expect(edges(3)).toEqual({ left: [1, 2], right: null });
    expect(edges(4)).toEqual({ left: null, right: null });
  });
});
