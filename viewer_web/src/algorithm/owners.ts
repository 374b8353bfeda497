import type { Pixel } from '../picture/pixel.js';
import type { Screen } from '../replay/screen.js';
import type { Trace } from '../replay/trace.js';
import { algorithmOf } from './algorithm.js';

/** The owners of a colour: one polygon or the background, or all that have the colour if the trace does not say which. */
export interface Owners {
  readonly polygons: readonly string[];
  readonly background: boolean;
}

export const ownedBy = (...polygons: readonly string[]): Owners => ({
  polygons,
  background: false,
});
export const nobody = ownedBy();

/** The owners of the colours that the steps of a trace painted, by these steps. */
const shown = new WeakMap<Trace, Map<number, Owners>>();

/** The owners of a pixel of the trace's current screen; null if it is not painted. */
export function ownersAt(trace: Trace, screen: Screen, [x, y]: Pixel): Owners | null {
  const step = screen.painter(x, y);
  if (step === 0) return null;
  const known = shown.get(trace) ?? new Map<number, Owners>();
  shown.set(trace, known);
  const owners = known.get(step) ?? shownBy(trace, step);
  known.set(step, owners);
  return owners;
}

function shownBy({ header, timeline }: Trace, step: number): Owners {
  const event = timeline.event(step);
  if (event === null) return nobody;
  return algorithmOf(header).owners?.(event, timeline.valuesAt(step), header) ?? nobody;
}
