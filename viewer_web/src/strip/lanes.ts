import { hasWindows } from '../trace/events.js';
import type { Header } from '../trace/header.js';

/** What a strip shows, from above: what is in hand, how finely the area is split, changes of AEL, calls. */
export type LaneName = 'cases' | 'polygons' | 'levels' | 'ael' | 'calls';

/** A lane of the strip, in CSS pixels. */
export interface Lane {
  readonly name: LaneName;
  readonly top: number;
  readonly height: number;
}

/** Above the lanes: wrong decisions, faults, bookmarks. */
export const marksHeight = 10;
export const stripHeight = 52;
const gap = 2;

const heights: Readonly<Record<Exclude<LaneName, 'cases' | 'polygons'>, number>> = {
  levels: 12,
  ael: 10,
  calls: 10,
};

function namesOf({ method, detail }: Header): readonly (keyof typeof heights)[] {
  if (detail === 'windows') return hasWindows(method) ? ['levels'] : [];
  return hasWindows(method) ? ['levels', 'calls'] : ['ael', 'calls'];
}

/** The lanes for which a trace of this detail has events; the first takes what the others leave. */
export function lanesOf(header: Header): readonly Lane[] {
  const others = namesOf(header);
  const taken = others.reduce((sum, name) => sum + heights[name] + gap, marksHeight);
  let top = marksHeight;
  const next = (name: LaneName, height: number): Lane => {
    const lane = { name, top, height };
    top += height + gap;
    return lane;
  };
  const first = hasWindows(header.method) ? 'cases' : 'polygons';
  return [next(first, stripHeight - taken), ...others.map((name) => next(name, heights[name]))];
}

/** A flag on a pole so high, as SVG path: what a bookmark looks like. */
export const flag = (height: number): string => `M0 0h9l-3 4 3 4h-7V${height}h-2Z`;
