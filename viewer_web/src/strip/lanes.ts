import { algorithmOf } from '../algorithm/algorithm.js';
import type { Header } from '../trace/header.js';

/**
 * The lanes of a strip, from top to bottom: the current item, how finely the area is divided, changes of the AEL, calls.
 */
export type LaneName = 'cases' | 'polygons' | 'curves' | 'levels' | 'ael' | 'calls';

/** A lane of the strip, in CSS pixels. */
export interface Lane {
  readonly name: LaneName;
  readonly top: number;
  readonly height: number;
}

/** The height of the marks above the lanes: wrong decisions, faults, bookmarks. */
export const marksHeight = 10;
export const stripHeight = 52;
const gap = 2;

type First = 'cases' | 'polygons' | 'curves';
type Below = Exclude<LaneName, First>;

/** The lanes for the runs of an algorithm. */
export interface Lanes {
  /** The lane of the current item. */
  readonly first: First;
  /** The lanes below it: those of the lowest level of detail, and those that need more. */
  readonly below: readonly [windows: readonly Below[], more: readonly Below[]];
}

const heights: Readonly<Record<Below, number>> = {
  levels: 12,
  ael: 10,
  calls: 10,
};

/** The lanes for which a trace of this detail has events; the first one fills the remaining height. */
export function lanesOf(header: Header): readonly Lane[] {
  const { first, below } = algorithmOf(header).lanes;
  const names = below[header.detail === 'windows' ? 0 : 1];
  const taken = names.reduce((sum, name) => sum + heights[name] + gap, marksHeight);
  let top = marksHeight;
  const next = (name: LaneName, height: number): Lane => {
    const lane = { name, top, height };
    top += height + gap;
    return lane;
  };
  return [next(first, stripHeight - taken), ...names.map((name) => next(name, heights[name]))];
}

/** A flag on a pole of a given height, as an SVG path: the icon of a bookmark. */
export const flag = (height: number): string => `M0 0h9l-3 4 3 4h-7V${height}h-2Z`;
