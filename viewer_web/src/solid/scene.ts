import { algorithmOf } from '../algorithm/algorithm.js';
import { polygonThing, thingOf } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import { numbersOf } from '../algorithm/view.js';
import type { SolidTexts } from '../language/texts.js';
import { Frame } from '../picture/frame.js';
import { labelsOf, many } from '../picture/still.js';
import { outlines, planeOf } from '../trace/polygon.js';
import type { OutlineLine } from '../trace/polygon.js';
import type { Area, Scene } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import { cased, level, placed, together } from './drawing.js';
import type { Drawing, Line } from './drawing.js';
import { around } from './plane.js';
import type { Space } from './space.js';

/** The largest side in pixels for which the picture's grid is drawn. */
const mostGrid = 64;

/**
 * The part that does not change from step to step: polygons and their names, the box, and the grid of pixels at its far
 * end.
 */
export function stillDrawing({ header: { scene } }: View, space: Space): Drawing {
  const isCrowded = scene.polygons.length > many;
  const outlineOf = outlines(scene.polygons);
  return placed(
    together(
      { lines: [...gridLines(scene.area, space.far), ...boxLines(scene.area, space)] },
      {
        faces: scene.polygons.map(({ vertices: points, color }) => ({ points, color })),
        lines: scene.polygons.flatMap((each) => outline(outlineOf(each), each.color, isCrowded)),
        labels: names(scene),
      },
    ),
    space,
  );
}

/** The part that a step adds. */
export function stepDrawing(view: View, space: Space): Drawing {
  return placed(
    together(
      algorithmOf(view.header).solid?.drawing(view, space) ?? {},
      pointedDrawing(view, space),
    ),
    space,
  );
}

function outline(
  lines: readonly OutlineLine[],
  color: string,
  isCrowded: boolean,
): readonly Line[] {
  return lines.flatMap((drawn): readonly Line[] => {
    const line: Line = { look: 'outline', ...drawn, color };
    return isCrowded
      ? [{ ...line, look: 'outline many' }]
      : [{ look: 'outline-casing', ...drawn }, line];
  });
}

function gridLines({ x, y, width, height }: Area, far: number): readonly Line[] {
  if (Math.max(width, height) > mostGrid) return [];
  const line = (...ends: readonly (readonly [number, number])[]): Line => ({
    look: 'grid',
    points: ends.map(([i, j]) => [i, j, far]),
    closed: false,
  });
  const within = (from: number, length: number): readonly number[] =>
    Array.from({ length: length - 1 }, (_, i) => from + i + 1);
  return [
    ...within(x, width).map((i) => line([i, y], [i, y + height])),
    ...within(y, height).map((j) => line([x, j], [x + width, j])),
  ];
}

function boxLines({ x, y, width, height }: Area, { far, near }: Space): readonly Line[] {
  const area: Box = [x, y, width, height];
  const ends = [far, near].map((z) => level(area, z));
  const edges = around(area).map(([i, j]) => [[i, j, far] as const, [i, j, near] as const]);
  return [
    ...ends.map((points): Line => ({ look: 'area', points, closed: true })),
    ...edges.map((points): Line => ({ look: 'area', points, closed: false })),
  ];
}

/** The names at the same places as in the picture, on the planes of the polygons. */
function names(scene: Scene): Drawing['labels'] {
  const spots = labelsOf(scene, new Frame(scene.area, { width: 1000, height: 1000 }));
  return spots.flatMap(({ text, of = '', at: [x, y] }) => {
    const polygon = scene.byId.get(of);
    if (polygon === undefined) return [];
    const z = planeOf(polygon)(x, y);
    return [{ text, at: [x, y, z], side: [0, 0], strong: true, thing: polygonThing(of) }];
  });
}

/** The thing that is pointed at anywhere on the page. */
function pointedDrawing(view: View, space: Space): Partial<Drawing> {
  const thing = thingOf(view.pointed, view);
  const { header } = view;
  if (thing === null) return {};
  switch (thing.kind) {
    case 'polygon':
      return { lines: cased('pointed', header.scene.byId.get(thing.id)?.vertices ?? []) };
    case 'window':
      return { lines: cased('pointed', level(thing.window, space.far)) };
    case 'pixel':
      return { lines: cased('pointed', level([...thing.at, 1, 1], space.far)) };
    case 'edge':
    case 'corner':
    case 'curve':
    case 'column':
      return algorithmOf(header).solid?.pointed?.(thing, view, space) ?? {};
  }
}

/** A description of the box: first what never changes in a scene, then what the step shows. */
export function caption(view: View, space: Space, texts: SolidTexts): readonly string[] {
  const [far, near] = space.depths.map(numbersOf(view).short);
  const depths = texts.depths(far ?? '', near ?? '');
  return [depths, ...(algorithmOf(view.header).solid?.caption(view, texts) ?? [])];
}
