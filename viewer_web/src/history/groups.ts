import { algorithmOf } from '../algorithm/algorithm.js';
import type { Heading } from '../algorithm/algorithm.js';
import type { Method } from '../trace/events.js';
import type { Entry } from './entry.js';

/** Consecutive entries with the same heading. */
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

/** The range of entries shown around one of them. It stays the same while the reader moves within it. */
export function shownAround(index: number, length: number): readonly [first: number, end: number] {
  const first = Math.max(0, (Math.floor(index / page) - 1) * page);
  return [first, Math.min(length, first + 3 * page)];
}
