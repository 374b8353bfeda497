import type { Finding } from '../exactness/finding.js';
import { callsFrom, details, kinds, numberOf } from '../trace/events.js';
import type { Detail, EventName, Procedure } from '../trace/events.js';

const newline = 10;
/** Long enough for the name of an event, and for the procedure of a call. */
const longest = 96;

/** Whether a level of detail has an event, given the line of a trace at level `signs`. */
export function hasLine(line: string, detail: Detail): boolean {
  const [, name = '', of = ''] = /^\{"e":"(\w+)"(?:,"at":"\w+","of":"(\w+)")?/.exec(line) ?? [];
  const { from } = kinds[name as EventName];
  const least = name === 'call' ? callsFrom[of as Procedure] : from;
  return details.indexOf(least) <= details.indexOf(detail);
}

/** A step of level `signs` at a coarser level: the step that contains it, and whether that step is the same event. */
export interface Leveled {
  readonly step: number;
  readonly isShown: boolean;
}

/** The steps of level `signs`, given in rising order, at a coarser level. A step contains what the run does up to its event. */
export function leveled(
  signs: Uint8Array<ArrayBuffer>,
  detail: Detail,
  steps: readonly number[],
): readonly Leveled[] {
  const found: Leveled[] = [];
  const decoder = new TextDecoder();
  let start = signs.indexOf(newline) + 1; // after the header
  let shown = 0;
  for (let step = 1; start > 0 && start < signs.length && found.length < steps.length; step++) {
    const end = signs.indexOf(newline, start);
    const line = decoder.decode(signs.subarray(start, Math.min(end, start + longest)));
    const isShown = line.startsWith('{"e":') && hasLine(line, detail);
    while (steps[found.length] === step) found.push({ step: shown + 1, isShown });
    if (isShown) shown++;
    start = end + 1;
  }
  // What follows the last event of the coarser level belongs to its last step.
  return found.map((each) => ({ ...each, step: Math.min(each.step, shown) }));
}

const disagree = numberOf.get('disagree');

/** Findings with the steps of a trace, which may report wrong decisions by steps of their own; those are not counted. */
export function placedIn(
  names: ArrayLike<number>,
  findings: readonly Finding[],
): readonly Finding[] {
  const steps: number[] = [];
  for (let i = 0; i < names.length; i++) if (names[i] !== disagree) steps.push(i + 1);
  return findings.map((each) => ({ ...each, step: steps[each.step - 1] ?? each.step }));
}
