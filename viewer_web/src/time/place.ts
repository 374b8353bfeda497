import type { Texts } from '../language/texts.js';
import type { Timeline } from '../replay/timeline.js';
import { numberOf } from '../trace/events.js';
import type { Event } from '../trace/events.js';
import type { Box } from '../trace/values.js';
import { bookmarkAt } from './bookmarks.js';
import type { Bookmarks } from './bookmarks.js';
import { cases } from './course.js';
import type { Case, Course } from './course.js';
import { indexFrom } from './goals.js';

/** The place of a step in a run. */
interface Place {
  readonly window: Box | null;
  readonly case: Case | null;
  readonly polygon: string | null;
  readonly curve: number | null;
  readonly row: number | null;
  readonly wrong: boolean;
  readonly fault: boolean;
}

const scanline = numberOf.get('scanline');

/** The last row begun in a stretch at or before a step. */
function rowAt({ trace: { timeline } }: Course, first: number, step: number): number | null {
  for (let at = step; at > first; at--) {
    const event = timeline.names[at - 1] === scanline ? timeline.event(at) : null;
    if (event?.e === 'scanline') return event.row;
  }
  return null;
}

const isAmong = (steps: readonly number[], step: number): boolean =>
  steps[indexFrom(steps, step)] === step;

const polygonOf = (begins: Event | null): string | null => {
  if (begins?.e === 'pop_list') return begins.clip;
  return begins?.e === 'polygon' ? begins.polygon : null;
};

function placeAt(course: Course, step: number): Place {
  const { header, timeline } = course.trace;
  const index = course.indexAt(step);
  const first = course.stretches.first[index] ?? 0;
  const begins = timeline.event(first);
  const decided = cases[course.stretches.part[index] ?? -1] ?? null;
  return {
    window: begins?.e === 'pop' ? begins.window : null,
    case: begins?.e === 'pop' ? decided : null,
    polygon: polygonOf(begins),
    curve: begins?.e === 'curve' ? begins.curve : null,
    row: header.method === 'zbuffer' && first > 0 ? rowAt(course, first, step) : null,
    wrong: isAmong(course.wrong, step),
    fault: isAmong(course.faults, step),
  };
}

/** "window 4 × 4 at (8, 0)". */
export const sayWindow = (
  [x, y, width, height]: Box,
  { strip, numbers }: Pick<Texts, 'strip' | 'numbers'>,
): string =>
  strip.windowAt(`${numbers.short(width)} × ${numbers.short(height)}`, numbers.point([x, y]));

/** "Step 120 of 800: window 4 × 4 at (8, 0), split". */
export function sayPlace(
  course: Course,
  step: number,
  bookmarks: Bookmarks,
  { strip, curves, numbers }: Texts,
): string {
  const place = placeAt(course, step);
  const { window, polygon, curve, row } = place;
  const bookmark = bookmarkAt(bookmarks, step);
  const said = [
    window && sayWindow(window, { strip, numbers }),
    place.case && strip.cases[place.case],
    polygon !== null && strip.polygon(polygon),
    curve !== null && curves.curve(curve).toLowerCase(),
    row !== null && strip.row(numbers.short(row)),
    place.wrong && strip.marks.wrong,
    place.fault && strip.marks.fault,
    bookmark && strip.bookmark(bookmark.note),
  ].filter((words) => typeof words === 'string');
  const at = strip.step(step, course.length);
  return said.length === 0 ? at : `${at}: ${said.join(', ')}`;
}

const verdict = numberOf.get('disagree') ?? -1;

/**
 * The step of another run after the same number of events as a step of this run, or its last step. Events that only report
 * a wrong decision do not count, because only checked runs of a scene have them.
 */
export function ownStep(from: Timeline, step: number, to: Timeline): number {
  const own = from.names.subarray(0, step).filter((name) => name !== verdict).length;
  let at = 0;
  for (let left = own; left > 0 && at < to.length; at++) if (to.names[at] !== verdict) left--;
  return at;
}
