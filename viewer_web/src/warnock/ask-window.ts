import { windowThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import type { Step } from '../predict/ahead.js';
import { mostOptions, optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { none } from '../predict/question.js';
import type { Part } from '../predict/question.js';
import type { Trace } from '../replay/trace.js';
import { cases } from '../time/course.js';
import { shownIn } from './lists.js';
import { ownersOf } from './naming.js';

/** The polygon that hides the others in a window; null if the trace does not have it. */
function hidingIn(
  trace: Trace,
  decide: Step<'decide'>,
  covers: readonly Step<'cover'>[],
): string | null {
  if (decide.event.case !== 'surrounded') return none;
  const cover = covers.at(-1);
  if (cover !== undefined) return cover.event.polygon;
  const fill = eventAt(trace, decide.step + 1, 'fill');
  if (fill === null) return null;
  const known = trace.timeline.seek(decide.step).values;
  const { polygons, background } = ownersOf(fill, known, trace.header);
  const [owner, ...others] = polygons;
  return owner === undefined || others.length > 0 || background ? null : owner;
}

/** Which case is this window? */
export const window: Asker<'window'> = {
  from: 'windows',
  at: ['pop'],
  ask(trace, step) {
    const { detail, scene } = trace.header;
    const isCoarse = detail === 'windows'; // lists then never get shorter than the first one
    if (isCoarse && scene.polygons.length > mostOptions) return null;
    const pop = eventAt(trace, step, 'pop');
    const decide = nextOf(trace, step, 'decide', 'pop');
    if (pop === null || decide === null) return null;
    const until = decide.step;
    const back = stepsOf(trace, step, until, 'rejoin');
    const now = trace.timeline.seek(back.at(-1)?.step ?? step).values.warnock;
    const ids = (now?.apl?.entries ?? []).map(([id]) => id);
    const shown = now === undefined ? [] : shownIn(now, scene);
    if (ids.length === 0 || shown.length > mostOptions) return null;
    const covers = stepsOf(trace, step, until, 'cover');
    const hiding = hidingIn(trace, decide, covers);
    if (hiding === null) return null;

    const cover = covers.slice(-1);
    const uncovers = stepsOf(trace, cover[0]?.step ?? until, until, 'uncover').slice(0, 1);
    const summary = stepsOf(trace, step, until, 'summary');
    const discards = [
      ...stepsOf(trace, step, until, 'discard'),
      ...stepsOf(trace, step, until, 'join'),
    ];
    const gone = discards.map(({ event }) => event.polygon);
    const stay: Part = {
      asks: 'stay',
      options: optionsOf(ids),
      right: ids.filter((id) => !gone.includes(id)),
      decidedBy: (id) =>
        discards.find(({ event }) => event.polygon === id)?.step ?? summary.at(-1)?.step,
    };
    return {
      kind: 'window',
      step,
      until,
      about: { window: pop.window },
      parts: [
        ...(isCoarse ? [] : [stay]),
        {
          asks: 'hides',
          options: optionsOf([...shown, none]),
          right: [hiding],
          decidedBy: () => cover[0]?.step,
        },
        { asks: 'case', options: optionsOf(cases), right: [decide.event.case] },
      ],
      because: inOrder(discards, cover, uncovers, summary, [decide]),
      things: [windowThing(pop.window)],
    };
  },
};
