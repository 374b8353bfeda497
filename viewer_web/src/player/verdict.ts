import { algorithmOf } from '../algorithm/algorithm.js';
import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import { differenceOf, known } from '../picture/layers.js';
import type { Exact } from '../picture/layers.js';
import type { Trace } from '../replay/trace.js';
import { eventNames } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import type { Header } from '../trace/header.js';

/** The largest scene that is compared with its exact picture without a request. */
const most = { pixels: 1 << 16, polygons: 200 };

/** The events that a verdict counts: the first kind in this list that the run has. */
const counted = ['windows', 'regions', 'curves', 'comparisons'] as const;

/** Whether the exact picture of a scene is made as soon as its run is over. */
export function isComparedUnasked({ scene }: Pick<Header, 'scene'>): boolean {
  const { area, polygons, curves } = scene;
  const isSmall = area.width * area.height <= most.pixels && polygons.length <= most.polygons;
  return curves === null && isSmall;
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
 * The result of a run at its end: the size of its picture, the comparison with the exact picture, and the number of
 * operations.
 */
export function verdictOn(trace: Trace, view: View, exact: Exact): string | null {
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
  const pixels =
    curves === null
      ? [`${verdict.pixels(area.width * area.height)}, ${comparedWith(exact, view)}`]
      : [];
  const untold = curves === null ? [] : [verdict.notCompared];
  return `${[...pixels, ...work, ...untold].join('; ')}.`;
}

/** Claims exactness only after a comparison with the exact picture. */
function comparedWith(exact: Exact, view: View): string {
  const { verdict } = texts[view.language];
  const right = known(exact);
  if (right === null) {
    const isAwaited = exact === 'computing' && isComparedUnasked(view.header);
    return isAwaited ? verdict.comparing : verdict.notCompared;
  }
  const { wrong, lacking } = differenceOf(view.screen.picture, right);
  return wrong + lacking === 0 ? verdict.allRight : verdict.someWrong(wrong + lacking);
}
