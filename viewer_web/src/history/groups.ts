import { algorithmOf } from '../algorithm/algorithm.js';
import type { Heading } from '../algorithm/algorithm.js';
import type { Method } from '../trace/events.js';
import type { Entry } from './entry.js';

/** Entries in a row that stand under the same heading. */
export interface Group {
  readonly under: Heading | null;
  readonly entries: readonly Entry[];
}

export function grouped(entries: readonly Entry[], method: Method): readonly Group[] {
  const algorithm = algorithmOf({ method });
  const groups: { under: Heading | null; entries: Entry[] }[] = [];
  for (const entry of entries) {
    const under = algorithm.heading(entry.known, entry.event);
    const last = groups.at(-1);
    if (last?.under === under) last.entries.push(entry);
    else groups.push({ under, entries: [entry] });
  }
  return groups;
}

const page = 40;

/** The entries that are shown around one of them. They stay while the reader moves among them. */
export function shownAround(index: number, length: number): readonly [first: number, end: number] {
  const first = Math.max(0, (Math.floor(index / page) - 1) * page);
  return [first, Math.min(length, first + 3 * page)];
}
