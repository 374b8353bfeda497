import type { Entry, Heading } from './entry.js';

/** Consecutive entries with the same heading. */
export interface Group {
  readonly under: Heading | null;
  readonly entries: readonly Entry[];
}

export function grouped(entries: readonly Entry[]): readonly Group[] {
  const groups: { under: Heading | null; entries: Entry[] }[] = [];
  for (const entry of entries) {
    const { under } = entry;
    const last = groups.at(-1);
    if (last !== undefined && isSame(last.under, under)) last.entries.push(entry);
    else groups.push({ under, entries: [entry] });
  }
  return groups;
}

/** Whether two headings name the same window, polygon or curve. */
const isSame = (one: Heading | null, other: Heading | null): boolean =>
  String(one) === String(other);

const page = 40;

/** The range of entries shown around one of them. It stays the same while the reader moves within it. */
export function shownAround(index: number, length: number): readonly [first: number, end: number] {
  const first = Math.max(0, (Math.floor(index / page) - 1) * page);
  return [first, Math.min(length, first + 3 * page)];
}
