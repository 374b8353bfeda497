import type { Box } from '../trace/values.js';
import type { Mark, Spot } from './mark.js';
import type { Pixel } from './pixel.js';

const dot = 5;
const reach = 9;

/** A shape in the plane: the classes for its look, and its path data, as in the `d` of a path. */
export interface Shape {
  readonly look: string;
  readonly d: string;
  /** The colour of the line, in place of the look's own. */
  readonly color?: string;
  /** The colour of the inside, likewise. */
  readonly fill?: string;
  /** The thing to point at with it; see `pointed.ts`. */
  readonly thing?: string;
}

/** The shapes of a mark, at a scale of CSS pixels per unit. */
export function shapesOf(mark: Mark, scale: number): readonly Shape[] {
  if (mark.kind === 'note') return [];
  if (mark.kind === 'point') {
    return [{ look: `dot ${mark.role}`, d: circleData(mark.at, dot / scale) }];
  }
  const shape: Shape = { look: mark.role, d: dataOf(mark, scale) };
  const color = mark.kind === 'path' ? mark.color : undefined;
  return [
    { ...shape, look: `casing ${mark.role}` },
    color === undefined ? shape : { ...shape, color },
  ];
}

function dataOf(mark: Exclude<Mark, { kind: 'point' | 'note' }>, scale: number): string {
  if (mark.kind === 'box') return boxData(mark.box);
  if (mark.kind === 'boxes') return boxesData(mark.boxes);
  if (mark.kind === 'target') return aim(mark.at, reach / scale);
  return pathData(mark.points, mark.closed);
}

const known = new WeakMap<readonly Box[], string>();

/** The path data of boxes, cached: there may be thousands, and most steps do not change them. */
function boxesData(boxes: readonly Box[]): string {
  const d = known.get(boxes) ?? sidesData(boxes);
  known.set(boxes, d);
  return d;
}

type Part = readonly [from: number, to: number];

/** Parts of parallel lines, by the coordinate that all points of a line share. */
class Parallels {
  private readonly parts = new Map<number, Part[]>();

  add(line: number, ...part: Part): void {
    const parts = this.parts.get(line);
    if (parts === undefined) this.parts.set(line, [part]);
    else parts.push(part);
  }

  /** The parts, joined where they overlap or touch. */
  joined(): readonly (readonly [line: number, ...Part])[] {
    return [...this.parts].flatMap(([line, parts]) => {
      const found: [line: number, ...Part][] = [];
      for (const [from, to] of parts.sort(([a], [b]) => a - b)) {
        const last = found.at(-1);
        if (last === undefined || from > last[2]) found.push([line, from, to]);
        else last[2] = Math.max(last[2], to);
      }
      return found;
    });
  }
}

/** The path data of the sides of boxes, in which a side that boxes share is drawn once. */
export function sidesData(boxes: readonly Box[]): string {
  const rows = new Parallels();
  const columns = new Parallels();
  for (const [x, y, width, height] of boxes) {
    for (const side of [y, y + height]) rows.add(side, x, x + width);
    for (const side of [x, x + width]) columns.add(side, y, y + height);
  }
  const across = rows.joined().map(([y, from, to]) => `M${from} ${y}H${to}`);
  const down = columns.joined().map(([x, from, to]) => `M${x} ${from}V${to}`);
  return [...across, ...down].join('');
}

/** The outline of a pixel, and lines towards it. */
function aim([x, y]: Pixel, far: number): string {
  const across = `M${x - far} ${y + 0.5}h${far}M${x + 1} ${y + 0.5}h${far}`;
  const down = `M${x + 0.5} ${y - far}v${far}M${x + 0.5} ${y + 1}v${far}`;
  return `${boxData([x, y, 1, 1])}${across}${down}`;
}

/** The path data of a rectangle. */
export function boxData([x, y, width, height]: Box): string {
  return `M${x} ${y}h${width}v${height}h${-width}Z`;
}

export function circleData([x, y]: Spot, r: number): string {
  return `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
}

export function diamondData([x, y]: Spot, r: number): string {
  return `M${x - r} ${y}l${r} ${-r}l${r} ${r}l${-r} ${r}Z`;
}

/** A path supports only numbers in the range of a float. */
const farthest = 1e30;
const held = (coordinate: number): number => Math.min(Math.max(coordinate, -farthest), farthest);

/** The path data through the points. */
export function pathData(points: readonly (readonly number[])[], closed: boolean): string {
  if (points.length === 0) return '';
  return `M${points.map(([x = 0, y = 0]) => `${held(x)} ${held(y)}`).join('L')}${closed ? 'Z' : ''}`;
}
