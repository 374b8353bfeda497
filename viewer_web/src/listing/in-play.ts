import { algorithmOf } from '../algorithm/algorithm.js';
import type { Numbers } from '../language/texts.js';
import { depthChanges } from '../replay/state.js';
import type { Trace } from '../replay/trace.js';
import { noteOf } from './notes.js';

/** So far back is looked for values: a long list of polygons is not gone through at each step. */
const farthest = 400;

/** A label is its procedure's letters and the number of the line. */
function placeOf(label: string): readonly [procedure: string, line: number] {
  const letters = /^[A-Z]+/.exec(label)?.[0] ?? '';
  return [letters, Number(label.slice(letters.length))];
}

/**
 * What each line last said, by its label: in the procedures that run, on the way from where their loops last began.
 * What a later line said in a round before is over. The way begins with the window, the polygon, the curve, or the list in hand.
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
  let within = 0; // calls that were over
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
