import type { Known } from '../language/words.js';
import type { Box } from '../trace/values.js';
import type { Entry } from './entry.js';

/** A window, a polygon, or a curve. */
type Heading = Box | string | number;

/** Entries in a row that stand under the same heading. */
export interface Group {
  readonly under: Heading | null;
  readonly entries: readonly Entry[];
}

const headingOf = ({ event, known }: Entry): Heading | null => {
  // Once regions are painted no list is in hand.
  if (event.e === 'paint' || event.e === 'order') return event.polygon;
  return known.warnock?.window ?? known.zbuffer?.polygon ?? known.horizon?.curve ?? clipOf(known);
};

/** Whose piece the clip polygon of the list in hand is. */
const clipOf = ({ regions }: Known): string | null => regions?.inHand?.pieces[0]?.[0] ?? null;

export function grouped(entries: readonly Entry[]): readonly Group[] {
  const groups: { under: Heading | null; entries: Entry[] }[] = [];
  for (const entry of entries) {
    const under = headingOf(entry);
    const last = groups.at(-1);
    if (last?.under === under) last.entries.push(entry);
    else groups.push({ under, entries: [entry] });
  }
  return groups;
}

const page = 40;

/** The part of so many entries that is shown around one of them; it stays while one goes about in it. */
export function shownAround(index: number, length: number): readonly [first: number, end: number] {
  const first = Math.max(0, (Math.floor(index / page) - 1) * page);
  return [first, Math.min(length, first + 3 * page)];
}
