import { isShown, spot } from '../picture/mark.js';
import type { Spot } from '../picture/mark.js';
import type { Region } from '../trace/values.js';

/**
 * Geometry of regions for drawing and texts, in doubles, which are accurate enough for display. The decisions of the run
 * are in its events.
 */

export type Loops = readonly (readonly Spot[])[];

const known = new WeakMap<Region, Loops>();

/** The loops of a region to draw, without those that have a non-finite point. */
export function loopsOf(region: Region): Loops {
  const loops = known.get(region);
  if (loops !== undefined) return loops;
  const made = region.map((loop) => loop.map(spot)).filter((loop) => loop.every(isShown));
  known.set(region, made);
  return made;
}

export const verticesOf = (region: Region): number =>
  region.reduce((sum, loop) => sum + loop.length, 0);

/** Visits each edge of the loops. */
function forEachEdge(loops: Loops, visit: (from: Spot, to: Spot) => void): void {
  for (const loop of loops) {
    let from = loop.at(-1);
    for (const to of loop) {
      if (from !== undefined) visit(from, to);
      from = to;
    }
  }
}

/** The area in square pixels. Holes have the opposite direction and count as negative. */
export function areaOf(region: Region): number {
  let twice = 0;
  forEachEdge(loopsOf(region), ([x1, y1], [x2, y2]) => (twice += x1 * y2 - x2 * y1));
  return Math.abs(twice) / 2;
}

/** The bounding box of a region. */
export interface Bounds {
  readonly from: Spot;
  readonly to: Spot;
}

export function boundsOf(region: Region): Bounds {
  const spots = loopsOf(region).flat();
  const xs = spots.map(([x]) => x);
  const ys = spots.map(([, y]) => y);
  return { from: [Math.min(...xs), Math.min(...ys)], to: [Math.max(...xs), Math.max(...ys)] };
}

/** Whether a region contains a point; a point on the outline may count as either. */
export function holds(region: Region, [x, y]: Spot): boolean {
  let inside = false;
  forEachEdge(loopsOf(region), ([x1, y1], [x2, y2]) => {
    if (y1 > y === y2 > y) return;
    if (x < x1 + ((y - y1) * (x2 - x1)) / (y2 - y1)) inside = !inside;
  });
  return inside;
}

/** The path data of a region's outline. */
export const regionData = (region: Region): string =>
  loopsOf(region)
    .map((loop) => `M${loop.map(([x, y]) => `${x} ${y}`).join('L')}Z`)
    .join('');

/**
 * Hatching lines at a distance from each other, on which x + slope · y is constant, clipped to a region and to the bounding
 * box of what is seen.
 */
export function hatchData(
  region: Region,
  slope: 1 | -1,
  apart: number,
  [left, top, width, height]: readonly [number, number, number, number],
): string {
  const loops = loopsOf(region);
  if (loops.length === 0) return '';
  const across = ([x, y]: Spot): number => x + slope * y;
  const seen: readonly Spot[] = [
    [left, top],
    [left + width, top],
    [left, top + height],
    [left + width, top + height],
  ];
  const within = loops.flat().map(across);
  const first = Math.max(Math.min(...within), Math.min(...seen.map(across)));
  const last = Math.min(Math.max(...within), Math.max(...seen.map(across)));
  let d = '';
  for (let i = Math.floor(first / apart) + 1; i * apart < last; i++) {
    const met = meetings(loops, across, i * apart);
    for (let k = 0; k + 1 < met.length; k += 2) {
      d += `M${met[k]?.join(' ')}L${met[k + 1]?.join(' ')}`;
    }
  }
  return d;
}

/** The intersections of a line with the loops, from left to right. */
function meetings(loops: Loops, across: (at: Spot) => number, at: number): readonly Spot[] {
  const met: Spot[] = [];
  forEachEdge(loops, (from, to) => {
    const [a, b] = [across(from), across(to)];
    if (a > at === b > at) return;
    const part = (at - a) / (b - a);
    met.push([from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]);
  });
  return met.sort(([x1], [x2]) => x1 - x2);
}
