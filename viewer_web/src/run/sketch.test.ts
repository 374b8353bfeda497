import { describe, expect, it } from 'vitest';
import { parseHeader } from '../testing/traces.js';
import * as sketch from './sketch.js';
import type { Sketch, Vertex } from './sketch.js';

const triangle: readonly Vertex[] = [
  [0, 0, 0],
  [4, 0, 0],
  [0, 4, 1],
];
/** On the plane z = y / 4. */
const square: readonly Vertex[] = [
  [0, 0, 0],
  [4, 0, 0],
  [4, 4, 1],
  [0, 4, 1],
];

const drawing = (...outlines: readonly (readonly Vertex[])[]): Sketch =>
  outlines.reduce((drawn, outline) => sketch.addPolygon(drawn, outline), sketch.emptySketch);
const verticesOf = (drawn: Sketch): readonly Vertex[] => drawn.polygons[0]?.vertices ?? [];
const ids = (drawn: Sketch): string => drawn.polygons.map(({ id }) => id).join('');

describe('a corner that is moved', () => {
  it('of a triangle keeps its depth', () => {
    const moved = sketch.moveVertex(drawing(triangle), { polygon: 0, vertex: 2 }, 1, 5);
    expect(verticesOf(moved)).toEqual([
      [0, 0, 0],
      [4, 0, 0],
      [1, 5, 1],
    ]);
  });

  it('of more than three follows the plane of the first three', () => {
    const moved = sketch.moveVertex(drawing(square), { polygon: 0, vertex: 3 }, -1, 2);
    expect(verticesOf(moved)[3]).toEqual([-1, 2, 0.5]); // z = y / 4
  });

  it('changes the others if it is one of the first three', () => {
    // The plane through (0, 0, 0), (4, 0, 0), (4, 2, 1) is z = y / 2.
    const moved = sketch.moveVertex(drawing(square), { polygon: 0, vertex: 2 }, 4, 2);
    expect(verticesOf(moved)[3]).toEqual([0, 4, 2]);
  });

  it('keeps the objects of the other polygons', () => {
    const before = drawing(square, triangle);
    const after = sketch.moveVertex(before, { polygon: 0, vertex: 0 }, 1, 1);
    expect(after.polygons[1]).toBe(before.polygons[1]);
    expect(before.polygons[0]?.vertices).toEqual(square);
  });
});

describe('a drawn polygon', () => {
  const outline = [
    [0, 0],
    [2, 0],
    [0, 2],
  ] as const;

  it('lies in front of all others', () => {
    const drawn = sketch.drawPolygon(drawing(square, triangle), outline);
    const [first] = drawn.polygons.at(-1)?.vertices ?? [];
    expect(first?.[2]).toBeGreaterThan(1); // the nearest corner of the others
    expect(verticesOf(sketch.drawPolygon(sketch.emptySketch, outline))[0]).toEqual([0, 0, 0]);
  });

  it('has one depth, which can be changed at once', () => {
    const drawn = sketch.drawPolygon(sketch.emptySketch, outline);
    expect(sketch.depthOf(drawn, 0)).toBe(0);
    const far = sketch.setDepthOfAll(drawn, 0, -1.5);
    expect(verticesOf(far)).toEqual(outline.map(([x, y]) => [x, y, -1.5]));
    expect(sketch.depthOf(drawing(triangle), 0)).toBeNull(); // it is tilted
  });
});

describe('a depth that is set', () => {
  it('tilts the plane, and the corners without a depth of their own follow', () => {
    // Through (0, 0, 0), (4, 0, 1/2), (4, 4, 1): z = x / 8 + y / 8, which is 1/2 at (0, 4).
    const tilted = sketch.setDepth(drawing(square), { polygon: 0, vertex: 1 }, 0.5);
    expect(verticesOf(tilted)[3]).toEqual([0, 4, 0.5]);
  });
});

describe('the corners with a depth of their own', () => {
  it.each<[string, readonly Vertex[], readonly number[] | null]>([
    ['are the first three', square, [0, 1, 2]],
    [
      'leave out what is in line',
      [
        [0, 0, 0],
        [2, 0, 0],
        [4, 0, 0],
        [4, 4, 0],
      ],
      [0, 1, 3],
    ],
    [
      'leave out what is there twice',
      [
        [0, 0, 0],
        [0, 0, 0],
        [4, 0, 0],
        [4, 4, 0],
      ],
      [0, 2, 3],
    ],
    [
      'are none if all are in line',
      [
        [0, 0, 0],
        [1, 1, 0],
        [2, 2, 0],
      ],
      null,
    ],
  ])('%s', (_, vertices, own) => {
    expect(sketch.anchors(vertices)).toEqual(own);
  });
});

describe('corners', () => {
  it('are added in the middle of an edge, including the last one', () => {
    const split = sketch.splitEdge(drawing(square), { polygon: 0, vertex: 3 });
    expect(verticesOf(split)[4]).toEqual([0, 2, 0.5]);
  });

  it('are removed down to three', () => {
    const three = sketch.removeVertex(drawing(square), { polygon: 0, vertex: 1 });
    expect(verticesOf(three)).toHaveLength(3);
    expect(sketch.removeVertex(three, { polygon: 0, vertex: 1 })).toBe(three);
  });
});

describe('polygons', () => {
  it('get the first free letter', () => {
    const two = sketch.rename(drawing(triangle, triangle), 0, 'C');
    expect(ids(two)).toBe('CB');
    expect(ids(sketch.addPolygon(sketch.addPolygon(two, square), square))).toBe('CBAD');
  });

  it('have different colours as long as the palette has any left', () => {
    const taken = ['#0072b2', '#d55e00'].map((color, i) => ({
      id: String(i),
      color,
      vertices: triangle,
    }));
    const added = sketch.addPolygon({ ...sketch.emptySketch, polygons: taken }, triangle);
    // Two are taken, and the third of the palette is one of them.
    expect(added.polygons.map(({ color }) => color)).toEqual(['#0072b2', '#d55e00', '#56b4e9']);
  });

  it('keep their names distinct', () => {
    const two = drawing(triangle, triangle);
    expect(sketch.rename(two, 0, 'B')).toBe(two);
    expect(sketch.rename(two, 0, '')).toBe(two);
  });

  it('change places, but not beyond the ends', () => {
    const three = drawing(triangle, triangle, triangle);
    expect(ids(sketch.reorder(three, 0, 1))).toBe('BAC');
    expect(ids(sketch.reorder(three, 2, -1))).toBe('ACB');
    expect(sketch.reorder(three, 0, -1)).toBe(three);
  });

  it('move as a whole without changing depth', () => {
    expect(verticesOf(sketch.movePolygon(drawing(triangle), 0, 1, -2))).toEqual([
      [1, -2, 0],
      [5, -2, 0],
      [1, 2, 1],
    ]);
  });
});

describe('a sketch reaches out of its area', () => {
  it.each([
    [4, 4, false],
    [4.5, 4, true],
    [0, -0.5, true],
    [-1, 0, true],
    [2, 5, true],
  ])('with a vertex at (%d, %d): %s', (x, y, reaches) => {
    const drawn = sketch.resize(
      drawing([
        [0, 0, 0],
        [4, 0, 0],
        [x, y, 0],
      ]),
      {
        x: 0,
        y: 0,
        width: 4,
        height: 4,
      },
    );
    expect(sketch.reachesOut(drawn)).toBe(reaches);
  });
});

describe('the file of a scene', () => {
  const drawn = { ...drawing(square, triangle), name: 'Two "polygons"' };
  const header = (scene: unknown): object => ({
    format: 'vidno-trace/1',
    method: 'warnock',
    edition: 'corrected',
    kernel: 'double',
    detail: 'signs',
    scene,
  });

  it.each([
    ['on one line', sketch.sceneText(drawn)],
    ['for people', sketch.sceneFile(drawn)],
    ['for people, empty', sketch.sceneFile({ ...drawn, polygons: [] })],
  ])('%s is read as the same scene', (name, text) => {
    const { scene } = parseHeader(header(JSON.parse(text)));
    expect(scene.name).toBe('Two "polygons"');
    expect(scene.area).toEqual(drawn.area);
    expect(scene.polygons).toEqual(name.endsWith('empty') ? [] : drawn.polygons);
  });
});
