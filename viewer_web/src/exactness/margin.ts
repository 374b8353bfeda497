import { toNumber } from '../language/words.js';
import { note, path } from '../picture/mark.js';
import type { Mark, Spot } from '../picture/mark.js';
import { bool, list, oneOf, optional, point, text, whole } from '../trace/values.js';
import { part } from '../trace/check.js';
import type { Checked } from '../trace/check.js';
import type { Area } from '../trace/header.js';
import { Fraction } from './fraction.js';

const sign = oneOf(-1, 0, 1);

/** Where a vertex may be moved to so that no sign of a step changes, as `vidno margin --json` says it; FORMAT.md says what it means. */
const margin = part({
  step: whole,
  polygon: text,
  vertex: whole,
  sides: list(
    part({
      a: text,
      b: text,
      c: text,
      sign,
      bounds: bool,
      flips: list(
        part({
          step: whole,
          polygon: text,
          edge: optional(whole),
          vertex: optional(whole),
          point: optional(point),
          cut: optional(whole),
          side: optional(whole),
          sign,
        }),
      ),
    }),
  ),
});
export type Margin = Checked<typeof margin>;
type Side = Margin['sides'][number];

export const marginIn = (json: string): Margin => margin(JSON.parse(json) as unknown, '');

/** The number that a fraction is nearly, however long it is. */
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

/** What of a convex polygon lies in a half-plane. */
function clipped(outline: readonly Spot[], at: (spot: Spot) => number): readonly Spot[] {
  return outline.flatMap((to, i) => {
    const from = outline[(i + outline.length - 1) % outline.length] ?? to;
    const [before, here] = [at(from), at(to)];
    const meets = before * here < 0;
    const t = before / (before - here);
    const cut: Spot = [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
    return [...(meets ? [cut] : []), ...(here >= 0 ? [to] : [])];
  });
}

/** The region within a frame about the area; empty if a sign is zero, for then it is a part of a line. */
export function regionOf({ sides }: Margin, { x, y, width, height }: Area): readonly Spot[] {
  const frame: readonly Spot[] = [
    [x - 4 * width, y - 4 * height],
    [x + 5 * width, y - 4 * height],
    [x + 5 * width, y + 5 * height],
    [x - 4 * width, y + 5 * height],
  ];
  if (sides.some((side) => side.sign === 0)) return [];
  return sides.map(halfPlane).reduce((region, { at }) => clipped(region, at), frame);
}

/** A few letters about what changes beyond a side: an edge and a point, or a vertex or a cut and a side of the window. */
export function labelOf({ flips }: Side): string {
  return flips
    .map(({ edge, vertex, point: at, cut, side }) => {
      if (at !== undefined) return `${edge ?? ''} (${at.map(toNumber).join(', ')})`;
      const what = vertex === undefined ? `${edge ?? ''}/${cut ?? ''}` : `v${vertex}`;
      return `${what} | ${side ?? ''}`;
    })
    .join('; ');
}

/** The region, shaded, with what changes beyond each of its sides. */
export function marginMarks(found: Margin, area: Area): readonly Mark[] {
  const region = regionOf(found, area);
  if (region.length < 3) return [];
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
      return seen === undefined ? [] : [note(seen, labelOf(side))];
    });
  return [path('margin', region, true), ...notes];
}
