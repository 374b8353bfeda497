import { polygonThing } from '../algorithm/pointed.js';
import { outlines } from '../trace/polygon.js';
import type { OutlineLine } from '../trace/polygon.js';
import type { Polygon, Scene } from '../trace/header.js';
import type { Frame } from './frame.js';
import type { Mark } from './mark.js';
import { nearestIn } from './pixel.js';
import type { Pixel } from './pixel.js';
import { boxData, pathData } from './shapes.js';
import type { Shape } from './shapes.js';

const mostLabels = 26;
const mostLetters = 32;
const mostOutlines = 3000;
/** The number of polygons above which their outlines are faint. */
export const many = 40;
const gridFrom = 7;

/** CSS pixels. */
export const labelSize = 13;
/** The usual width of a letter of a label. */
const letterWidth = labelSize * 0.62;

/** The visible lines between pixels, if they are far enough apart. */
export function gridShapes({ area, shown, scale }: Frame): readonly Shape[] {
  if (scale < gridFrom) return [];
  const [left, top] = nearestIn([Math.floor(shown[0]), Math.floor(shown[1])], area);
  const ends: Pixel = [Math.ceil(shown[0] + shown[2]), Math.ceil(shown[1] + shown[3])];
  const [right, bottom] = nearestIn(ends, area);
  const [width, height] = [right + 1 - left, bottom + 1 - top];
  const columns = Array.from({ length: width + 1 }, (_, i) => `M${left + i} ${top}v${height}`);
  const rows = Array.from({ length: height + 1 }, (_, j) => `M${left} ${top + j}h${width}`);
  return [{ look: 'grid', d: [...columns, ...rows].join('') }];
}

/** The area and the polygons, which do not change from step to step. */
export function outlineShapes({ area, polygons }: Scene): readonly Shape[] {
  const outlineOf = outlines(polygons);
  return [
    { look: 'area', d: boxData([area.x, area.y, area.width, area.height]) },
    ...polygons.slice(0, mostOutlines).flatMap((each) => {
      const d = outlineData(outlineOf(each));
      return polygons.length > many ? [faintOutline(each, d)] : outline(each, d);
    }),
  ];
}

/** Invisible outlines, wide enough to point at. */
export function shapesToPoint({ polygons }: Scene): readonly Shape[] {
  if (polygons.length > many) return [];
  return polygons.map(({ id, vertices }) => ({
    look: 'to-point',
    d: pathData(vertices, true),
    thing: polygonThing(id),
  }));
}

export const outlineData = (lines: readonly OutlineLine[]): string =>
  lines.map(({ points, closed }) => pathData(points, closed)).join('');

function outline({ color }: Polygon, d: string): readonly Shape[] {
  return [
    { look: 'outline-casing', d },
    { look: 'outline', d, color },
  ];
}

/** The outline of a polygon among many, faint because many outlines would hide the picture. */
function faintOutline({ color }: Polygon, d: string): Shape {
  return { look: 'outline many', d, color };
}

/** A polygon's name, shortened to the available room, and its centre in the plane. */
export interface Label {
  readonly text: string;
  /** The polygon of the name. */
  readonly of?: string;
  readonly at: readonly [x: number, y: number];
}

export function labelsOf({ polygons }: Scene, frame: Frame): readonly Label[] {
  if (polygons.length > mostLabels) return [];
  return polygons.map(({ id, vertices }) => {
    const text = clipped(id);
    return { text, of: id, at: labelSpot(text, vertices, frame) };
  });
}

function clipped(name: string): string {
  const letters = Array.from(name);
  return letters.length > mostLetters ? `${letters.slice(0, mostLetters - 1).join('')}…` : name;
}

/** The labels of marks, above and beside their places; a label out of sight is left out. */
export function notesOf(marks: readonly Mark[], { whole, scale }: Frame): readonly Label[] {
  const [left, top, width, height] = whole;
  const off = labelSize / scale;
  return marks.flatMap((mark) => {
    if (mark.kind !== 'note') return [];
    const [x, y] = mark.at;
    const isSeen = x > left && x < left + width && y > top && y < top + height;
    return isSeen ? [{ text: mark.text, at: [x + off * 0.8, y - off * 0.8] as const }] : [];
  });
}

/** A place a little inward from the first vertex, because the centres of polygons often coincide, and inside the picture. */
function labelSpot(
  text: string,
  vertices: Polygon['vertices'],
  { whole: [x, y, width, height], scale }: Frame,
): Label['at'] {
  const half = (Array.from(text).length * letterWidth) / 2 / scale;
  const within = (value: number, from: number, size: number, room: number): number => {
    const margin = Math.min(Math.max(size * 0.1, room), size / 2);
    return Math.min(Math.max(value, from + margin), from + size - margin);
  };
  const spot = (axis: 0 | 1): number => {
    const along = vertices.map((vertex) => vertex[axis]);
    const middle = along.reduce((sum, each) => sum + each, 0) / along.length;
    return (along[0] ?? 0) * 0.8 + middle * 0.2;
  };
  return [within(spot(0), x, width, half), within(spot(1), y, height, 0)];
}
