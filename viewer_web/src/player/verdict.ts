import type { View } from '../algorithm/view.js';
import type { Check } from '../exactness/truth.js';
import { texts } from '../i18n/index.js';
import { differenceOf, known } from '../picture/layers.js';
import type { Exact } from '../picture/layers.js';
import type { Comparison } from '../replay/timeline.js';
import type { Trace } from '../replay/trace.js';
import { numberOf } from '../trace/events.js';

/** The largest scene that is compared with its exact picture without a request, and the longest run of curves. */
const most = { pixels: 1 << 20, polygons: 5000, steps: 1 << 15 };

/** Whether a run is compared as soon as it is over: the picture of polygons, or the decisions of a run of curves. */
export function isComparedUnasked({ header, timeline }: Trace): boolean {
  const { area, polygons, curves } = header.scene;
  return curves === null
    ? area.width * area.height <= most.pixels && polygons.length <= most.polygons
    : timeline.length <= most.steps;
}

/** The verdict on a run at its end; null before, and of a part of a run. */
export function verdictOn(trace: Trace, view: View, exact: Exact, check: Check): string | null {
  const { header, step, length, language } = view;
  if (step !== length || length === 0 || !trace.complete || trace.shortened !== null) return null;
  const comparison =
    header.scene.curves === null ? ofPixels(exact, trace, view) : ofDecisions(check, trace);
  return trace.timeline.verdict(comparison, language);
}

/** The result for a first visitor, who knows no terms; null if the picture is not known to be right. */
export function welcomeOn(trace: Trace, view: View, exact: Exact): string | null {
  const { header, step, length } = view;
  const right = known(exact);
  if (step !== length || !trace.complete || right === null || header.scene.polygons.length < 2) {
    return null;
  }
  const { wrong, lacking } = differenceOf(view.screen.picture, right);
  return wrong + lacking === 0 ? texts[view.language].tour.welcome : null;
}

function ofPixels(exact: Exact, trace: Trace, view: View): Comparison {
  const right = known(exact);
  if (right === null) {
    return { is: exact === 'computing' && isComparedUnasked(trace) ? 'awaited' : 'unknown' };
  }
  const { wrong, lacking } = differenceOf(view.screen.picture, right);
  return { is: 'known', wrong: wrong + lacking };
}

/** The number of steps with wrong decisions in a checked trace, where the disagreements follow the step. */
function wrongSteps({ timeline: { names } }: Trace): number {
  const disagree = numberOf.get('disagree');
  return names.filter((name, i) => name === disagree && names[i - 1] !== disagree).length;
}

function ofDecisions(check: Check, trace: Trace): Comparison {
  switch (check.is) {
    case 'certain':
      return { is: 'known', wrong: 0 };
    case 'checked':
      return { is: 'known', wrong: wrongSteps(trace) };
    case 'found':
      return { is: 'known', wrong: check.truth.wrong.length };
    case 'checking':
      return { is: 'awaited' };
    case 'unchecked':
    case 'unable':
      return { is: 'unknown' };
  }
}
