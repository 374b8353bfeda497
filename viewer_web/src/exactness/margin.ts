import type { ExactTexts } from '../language/texts.js';
import { note, path } from '../picture/mark.js';
import type { Mark, Spot } from '../picture/mark.js';
import type { Area } from '../trace/header.js';
import type { N, Point } from '../trace/values.js';
import { Fraction } from './fraction.js';

/** A window's sides, in the order of PolygonClip. */
const sideNames = ['top', 'left', 'bottom', 'right'] as const;
export type WindowSide = (typeof sideNames)[number];
export type WindowCorner = `${'top' | 'bottom'}-${'left' | 'right'}`;

/** The most causes in one label: nobody reads more in a picture. */
const mostShown = 3;

/** The texts of a margin. */
export interface MarginWords {
  readonly say: ExactTexts['margin'];
  readonly point: (at: readonly N[]) => string;
}

type Sign = -1 | 0 | 1;

/** A sign that would change beyond a side of the region. */
interface Flip {
  readonly step: number;
  readonly polygon: string;
  readonly edge?: number;
  readonly vertex?: number;
  readonly point?: Point;
  readonly cut?: number;
  readonly side?: number;
  readonly sign: Sign;
}

/** A side of the region: a x + b y + c has the sign inside. */
interface Side {
  readonly a: string;
  readonly b: string;
  readonly c: string;
  readonly sign: Sign;
  readonly bounds: boolean;
  readonly flips: readonly Flip[];
}

/**
 * The region to which a vertex may be moved without changing a sign of a step, as `vidno margin --json` writes it.
 * FORMAT.md describes it.
 */
export interface Margin {
  readonly step: number;
  readonly polygon: string;
  readonly vertex: number;
  readonly sides: readonly Side[];
}

export const marginIn = (json: string): Margin => JSON.parse(json) as Margin;

/** The approximate value of a fraction of any length. */
function nearly(fraction: string): number {
  const exact = Fraction.parse(fraction);
  if (exact === null) return NaN;
  const { p, q } = exact;
  const size = Math.max(0, String(q).length - 15, String(p).length - 300);
  return Number(p / 10n ** BigInt(size)) / Number(q / 10n ** BigInt(size)) || Number(p) / Number(q);
}

interface HalfPlane {
  readonly side: Side;
  /** Positive inside. */
  readonly at: (spot: Spot) => number;
}

function halfPlane(side: Side): HalfPlane {
  const [a, b, c] = [nearly(side.a), nearly(side.b), nearly(side.c)];
  return { side, at: ([x, y]) => side.sign * (a * x + b * y + c) };
}

/** The part of a convex polygon, or of a segment, in a half-plane. */
function clipped(outline: readonly Spot[], at: (spot: Spot) => number): readonly Spot[] {
  const isSegment = outline.length === 2;
  return outline.flatMap((to, i) => {
    const from = outline[(i + outline.length - 1) % outline.length] ?? to;
    const [before, here] = [at(from), at(to)];
    const meets = before * here < 0 && !(isSegment && i === 0);
    const t = before / (before - here);
    const cut: Spot = [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
    return [...(meets ? [cut] : []), ...(here >= 0 ? [to] : [])];
  });
}

/** A line, cut to a segment that extends beyond the area. */
function segmentOn({ a, b, c }: Side, { x, y, width, height }: Area): readonly Spot[] {
  const [p, q] = [nearly(a), nearly(b)];
  const square = p * p + q * q;
  // The point of the line that is nearest to the middle of the area.
  const [middleX, middleY] = [x + width / 2, y + height / 2];
  const off = (p * middleX + q * middleY + nearly(c)) / square;
  const [footX, footY] = [middleX - p * off, middleY - q * off];
  const far = (5 * (width + height)) / Math.sqrt(square);
  return [
    [footX - q * far, footY + p * far],
    [footX + q * far, footY - p * far],
  ];
}

/**
 * The region within a frame around the area. Where a sign is zero the vertex must stay on its line, so the region is a
 * segment. If two signs are zero the region is empty: the vertex must not move at all.
 */
export function regionOf({ sides }: Margin, area: Area): readonly Spot[] {
  const { x, y, width, height } = area;
  const frame: readonly Spot[] = [
    [x - 4 * width, y - 4 * height],
    [x + 5 * width, y - 4 * height],
    [x + 5 * width, y + 5 * height],
    [x - 4 * width, y + 5 * height],
  ];
  const [line, ...others] = sides.filter(({ sign: of }) => of === 0);
  if (others.length > 0) return [];
  const whole = line === undefined ? frame : segmentOn(line, area);
  return sides
    .filter((side) => side !== line)
    .map(halfPlane)
    .reduce((region, { at }) => clipped(region, at), whole);
}

/** The changes beyond a side, in words. */
export function labelOf({ flips }: Side, { say, point: written }: MarginWords): string {
  const texts = flips.map(({ edge, point: at, cut, side }) => {
    if (edge !== undefined && at !== undefined) return say.edge(edge, written(at));
    if (edge !== undefined && cut !== undefined && side !== undefined) {
      const corner = cornerOf(cut, side);
      if (corner !== null) return say.edgeAtCorner(edge, corner);
    }
    return say.vertex(sideNames[(side ?? 1) - 1] ?? 'top');
  });
  const different = [...new Set(texts)];
  return [...different.slice(0, mostShown), ...(different.length > mostShown ? ['…'] : [])].join(
    '; ',
  );
}

/** The corner of the window at which two of its sides meet. */
function cornerOf(one: number, other: number): WindowCorner | null {
  const sides = new Set([one, other].map((number) => sideNames[number - 1]));
  const upright = sides.has('left') ? 'left' : sides.has('right') ? 'right' : null;
  const level = sides.has('top') ? 'top' : sides.has('bottom') ? 'bottom' : null;
  return upright === null || level === null ? null : `${level}-${upright}`;
}

/** A place near another one, where a centred label fits into the area. */
function besideIn({ x, y, width, height }: Area, [px, py]: Spot): Spot {
  const within = (value: number, from: number, size: number, edge: number): number =>
    Math.min(Math.max(value, from + edge * size), from + (1 - edge) * size);
  return [within(px, x, width, 0.35), within(py, y, height, 0.04)];
}

/** The region, shaded, with the changes beyond each of its sides. */
export function marginMarks(found: Margin, area: Area, words: MarginWords): readonly Mark[] {
  const region = regionOf(found, area);
  if (region.length < 2) return [];
  const { x, y, width, height } = area;
  const isInSight = ([px, py]: Spot): boolean =>
    px >= x - width && px <= x + 2 * width && py >= y - height && py <= y + 2 * height;
  const size = Math.hypot(width, height);
  const notes = found.sides
    .filter(({ bounds }) => bounds)
    .flatMap((side) => {
      const { at } = halfPlane(side);
      const unit = Math.hypot(nearly(side.a), nearly(side.b));
      const ends = region.filter((spot) => Math.abs(at(spot)) < 1e-9 * unit * size);
      const [from, to] = [ends[0], ends.at(-1)];
      if (from === undefined || to === undefined) return [];
      const middle: Spot = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
      const places = [middle, from, to];
      const seen = places.find(isInSight);
      return seen === undefined ? [] : [note(besideIn(area, seen), labelOf(side, words))];
    });
  return [path('margin', region, region.length > 2), ...notes];
}
