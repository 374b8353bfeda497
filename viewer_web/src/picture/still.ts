import { polygonThing } from '../algorithm/pointed.js';
import { outlines } from '../trace/polygon.js';
import type { OutlineLine } from '../trace/polygon.js';
import { toPixel } from '../replay/screen.js';
import type { Pixels } from '../replay/screen.js';
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
  /** Its colour, for a swatch before the name. */
  readonly color?: string;
  readonly at: readonly [x: number, y: number];
}

/** The width of a polygon's swatch and of the space after it, as a share of the size of a label. */
export const swatchWidth = 0.95;

/** The square in a polygon's colour before its name: its left side and size, and how far the name is moved, about the centre. */
export function swatchOf(
  { text, color }: Label,
  size: number,
): { readonly x: number; readonly size: number; readonly shift: number } | null {
  if (color === undefined) return null;
  const letters = (Array.from(text).length * letterWidth * size) / labelSize;
  return {
    x: -(letters + swatchWidth * size) / 2,
    size: 0.65 * size,
    shift: (swatchWidth * size) / 2,
  };
}

/** The width of a label in the plane. */
const widthOf = (text: string, { scale }: Frame): number =>
  (Array.from(text).length * letterWidth + swatchWidth * labelSize) / scale;

/**
 * The names of the polygons, each where the picture shows its polygon, as far as it does. A name stays at its place before
 * as long as that is so; if all do, the list is the same.
 */
export function labelsOf(
  { polygons }: Scene,
  frame: Frame,
  picture: Pixels | null = null,
  before: readonly Label[] = [],
): readonly Label[] {
  if (polygons.length > mostLabels) return [];
  const labels: Label[] = [];
  for (const polygon of polygons) {
    const known = before.find(({ of }) => of === polygon.id);
    if (known !== undefined && isSeenAt(polygon, known.at, frame, picture)) {
      labels.push(known);
      continue;
    }
    const text = clipped(polygon.id);
    const at = seenSpot(text, polygon, frame, picture, labels) ?? labelSpot(text, polygon, frame);
    const isSame = known?.at.join() === at.join() && known.color === polygon.color;
    labels.push(isSame ? known : { text, of: polygon.id, color: polygon.color, at });
  }
  const isSame = labels.length === before.length && labels.every((each, i) => each === before[i]);
  return isSame ? before : labels;
}

/** Whether the picture shows a polygon at a point: the pixel has its colour, and its outline contains the point. */
function isSeenAt(
  { color, vertices }: Polygon,
  [x, y]: Label['at'],
  { area }: Frame,
  picture: Pixels | null,
): boolean {
  const [i, j] = [Math.floor(x) - area.x, Math.floor(y) - area.y];
  const isInside = i >= 0 && j >= 0 && i < area.width && j < area.height;
  if (picture === null || !isInside || picture.at(i, j) !== toPixel(color)) return false;
  const sides = vertices.map(([x1, y1], k) => {
    const [x2, y2] = vertices[(k + 1) % vertices.length] ?? [x1, y1];
    return Math.sign((x2 - x1) * (y - y1) - (y2 - y1) * (x - x1));
  });
  return !(sides.includes(1) && sides.includes(-1));
}

/** How many places are tried along each side of the area. */
const tries = 24;

/**
 * The centre of a pixel where the picture shows the polygon, with room for its name: the more of its surroundings show the
 * polygon too, the better, then the nearer to the middle. Null if the picture does not show it.
 */
function seenSpot(
  text: string,
  polygon: Polygon,
  frame: Frame,
  picture: Pixels | null,
  taken: readonly Label[],
): Label['at'] | null {
  if (picture === null) return null;
  const { area, scale, whole } = frame;
  const { vertices } = polygon;
  const mean = (axis: 0 | 1): number =>
    vertices.reduce((sum, vertex) => sum + vertex[axis], 0) / vertices.length;
  const [x, y] = [mean(0), mean(1)];
  const half = [widthOf(text, frame) / 2, labelSize / 2 / scale] as const;
  const isFree = (at: Label['at']): boolean =>
    at[0] - half[0] >= whole[0] &&
    at[0] + half[0] <= whole[0] + whole[2] &&
    taken.every(
      (other) =>
        Math.abs(other.at[0] - at[0]) > half[0] + widthOf(other.text, frame) / 2 ||
        Math.abs(other.at[1] - at[1]) > 2 * half[1],
    );
  const shows = (at: Label['at']): boolean => isSeenAt(polygon, at, frame, picture);
  const around = ([atX, atY]: Label['at']): number =>
    [-1, -0.5, 0.5, 1]
      .flatMap((share) => [
        [atX + share * half[0], atY] as const,
        [atX, atY + 2 * share * half[1]] as const,
      ])
      .filter(shows).length;
  let best: { at: Label['at']; room: number; off: number } | null = null;
  for (const atY of placesIn(area.y, area.height)) {
    for (const atX of placesIn(area.x, area.width)) {
      const at = [atX, atY] as const;
      if (!shows(at) || !isFree(at)) continue;
      const [room, off] = [around(at), Math.hypot(atX - x, atY - y)];
      if (best === null || room > best.room || (room === best.room && off < best.off)) {
        best = { at, room, off };
      }
    }
  }
  return best?.at ?? null;
}

/** The centres of some pixels along a side. */
function placesIn(first: number, length: number): readonly number[] {
  const count = Math.min(tries, length);
  return Array.from(
    { length: count },
    (_, i) => first + Math.floor(((i + 0.5) * length) / count) + 0.5,
  );
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
function labelSpot(text: string, { vertices }: Polygon, frame: Frame): Label['at'] {
  const [x, y, width, height] = frame.whole;
  const half = widthOf(text, frame) / 2;
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
