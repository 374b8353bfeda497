import { algorithmOf } from '../algorithm/algorithm.js';
import type { Numbers } from '../language/texts.js';
import type { Trace } from '../replay/trace.js';
import { depthChanges } from '../trace/events.js';
import { noteOf } from './notes.js';

/** The number of steps to search for values, so that a step need not go through a long list of polygons. */
const farthest = 400;

/** The procedure's letters and the line number in a label. */
function placeOf(label: string): readonly [procedure: string, line: number] {
  const letters = /^[A-Z]+/.exec(label)?.[0] ?? '';
  return [letters, Number(label.slice(letters.length))];
}

/**
 * The last note of each line, by its label, in the running procedures since the start of their current loop iterations.
 * Notes of later lines from an earlier iteration are outdated. The search goes back to the start of the current window,
 * polygon, curve or list.
 */
export function valuesInPlay(
  { header, timeline }: Trace,
  step: number,
  numbers: Numbers,
): ReadonlyMap<string, string> {
  const changes = depthChanges(header.detail);
  const { begins } = algorithmOf(header);
  const values = new Map<string, string>();
  let lines = new Map<string, number>(); // in each procedure, the line reached on the way back
  let within = 0; // the depth inside calls that have returned
  for (let at = step; at > Math.max(0, step - farthest); at--) {
    const change = changes[timeline.names[at - 1] ?? 0] ?? 0;
    if (within > 0) {
      within -= change;
      continue;
    }
    const event = timeline.event(at);
    if (event === null) break;
    const [procedure, line] = placeOf(event.at);
    if (change > 0) lines = new Map();
    if (line <= (lines.get(procedure) ?? Infinity)) {
      const note = noteOf(event, header.method, numbers);
      if (note !== null && !values.has(event.at)) values.set(event.at, note);
      lines.set(procedure, line);
    }
    if (change < 0) within = 1;
    if (begins.includes(event.e)) break;
  }
  return values;
}
