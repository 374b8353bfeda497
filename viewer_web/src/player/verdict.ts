import { algorithmOf } from '../algorithm/algorithm.js';
import type { View } from '../algorithm/view.js';
import type { Check } from '../exactness/truth.js';
import { texts } from '../i18n/index.js';
import { differenceOf, known } from '../picture/layers.js';
import type { Exact } from '../picture/layers.js';
import type { Trace } from '../replay/trace.js';
import { eventNames, numberOf } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import type { Scene } from '../trace/header.js';

/** The largest scene that is compared with its exact picture without a request, and the longest run of curves. */
const most = { pixels: 1 << 20, polygons: 5000, steps: 1 << 15 };

/** The events that a verdict counts: the first kind in this list that the run has. */
const counted = ['windows', 'regions', 'curves', 'comparisons'] as const;

/** Whether a run is compared as soon as it is over: the picture of polygons, or the decisions of a run of curves. */
export function isComparedUnasked({ header, timeline }: Trace): boolean {
  const { area, polygons, curves } = header.scene;
  return curves === null
    ? area.width * area.height <= most.pixels && polygons.length <= most.polygons
    : timeline.length <= most.steps;
}

const tallies = new WeakMap<Trace, ReadonlyMap<EventName, number>>();

/** The number of events of each name in a whole run. */
function tallyOf(trace: Trace): ReadonlyMap<EventName, number> {
  const known = tallies.get(trace);
  if (known !== undefined) return known;
  const numbers = new Uint32Array(eventNames.length);
  const { names } = trace.timeline;
  for (const name of names) {
    numbers[name] = (numbers[name] ?? 0) + 1;
  }
  const tally = new Map(eventNames.map((name, i) => [name, numbers[i] ?? 0]));
  tallies.set(trace, tally);
  return tally;
}

/**
 * The result of a run at its end: the size of its picture, the comparison with exact arithmetic, and the number of
 * operations.
 */
export function verdictOn(trace: Trace, view: View, exact: Exact, check: Check): string | null {
  const { header, step, length } = view;
  if (step !== length || length === 0 || !trace.complete || trace.shortened !== null) return null;
  const { verdict } = texts[view.language];
  const { counts } = algorithmOf(header);
  const tally = tallyOf(trace);
  const amounts = counted.flatMap((counter) => {
    const events = counts[counter] ?? [];
    const n = events.reduce((sum, name) => sum + (tally.get(name) ?? 0), 0);
    return n === 0 ? [] : [verdict[counter](n)];
  });
  const { area, curves } = header.scene;
  const work = amounts.slice(0, 1);
  const parts =
    curves === null
      ? [
          `${verdict.pixels(area.width * area.height)}, ${comparedWith(exact, trace, view)}`,
          ...work,
        ]
      : [...work, decisionsOf(check, trace, view)];
  return `${verdict.finished}: ${parts.join('; ')}.`.replace('….', '…');
}

/** The result for a first visitor, who knows no terms; null if the picture is not known to be right. */
export function welcomeOn(trace: Trace, view: View, exact: Exact): string | null {
  const { header, step, length } = view;
  const right = known(exact);
  if (step !== length || !trace.complete || right === null || header.scene.polygons.length < 2) {
    return null;
  }
  const { wrong, lacking } = differenceOf(view.screen.picture, right);
  return wrong + lacking === 0 ? texts[view.language].verdict.welcome : null;
}

/** Whether a colour does not tell the polygon. */
const hasSharedColors = ({ polygons, background }: Scene): boolean =>
  new Set([background, ...polygons.map(({ color }) => color)]).size <= polygons.length;

const isCorrected = ({ header }: Trace): boolean => header.edition === 'corrected';

/** Claims exactness only after a comparison with the exact picture. */
function comparedWith(exact: Exact, trace: Trace, view: View): string {
  const { verdict } = texts[view.language];
  const right = known(exact);
  if (right === null) {
    const isAwaited = exact === 'computing' && isComparedUnasked(trace);
    return isAwaited ? verdict.comparing : verdict.notCompared;
  }
  const { wrong, lacking } = differenceOf(view.screen.picture, right);
  const others = wrong + lacking;
  if (others === 0) {
    return hasSharedColors(trace.header.scene) ? verdict.allColorsRight : verdict.allRight;
  }
  return isCorrected(trace) ? verdict.someWrong(others) : verdict.someOther(others);
}

/** The number of steps with wrong decisions in a checked trace, where the disagreements follow the step. */
function wrongSteps({ timeline: { names } }: Trace): number {
  const disagree = numberOf.get('disagree');
  return names.filter((name, i) => name === disagree && names[i - 1] !== disagree).length;
}

/** Claims exactness only after a check. */
function decisionsOf(check: Check, trace: Trace, view: View): string {
  const { verdict } = texts[view.language];
  const allRight = isCorrected(trace) ? verdict.decisionsRight : verdict.decisionsRightBut;
  switch (check.is) {
    case 'certain':
      return allRight;
    case 'checked':
    case 'found': {
      const wrong = check.is === 'found' ? check.truth.wrong.length : wrongSteps(trace);
      return wrong === 0 ? allRight : verdict.decisionsWrong(wrong);
    }
    case 'checking':
      return verdict.comparing;
    case 'unchecked':
    case 'unable':
      return verdict.notCompared;
  }
}
