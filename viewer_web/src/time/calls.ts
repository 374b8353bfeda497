import { closes, isTraced } from '../state/state.js';
import { eventNames } from '../trace/events.js';
import type { Detail } from '../trace/events.js';
import type { Trace } from '../trace/read.js';

export type Direction = -1 | 1;

/** For each number of an event's name by how much the calls are nested deeper after it. */
export function depthChanges(detail: Detail): readonly number[] {
  return eventNames.map((name) => {
    const closed = closes[name];
    if (name === 'call') return 1;
    return closed !== undefined && isTraced(closed, detail) ? -1 : 0;
  });
}

/** How deep the calls are nested after each step, and the ways over and out of them, forward and back alike. */
export class Calls {
  private readonly depths: Uint8Array;

  constructor({ header, timeline }: Trace) {
    const change = depthChanges(header.detail);
    this.depths = new Uint8Array(timeline.length + 1);
    let depth = 1;
    timeline.names.forEach((name, i) => {
      depth += change[name] ?? 0;
      this.depths[i + 1] = depth;
    });
    this.depths[0] = 1;
  }

  /** The next step, but a call with all that it does counts as one. */
  over(step: number, direction: Direction): number {
    return this.find(step, direction, this.depthAt(step));
  }

  /** The step that ends the procedure in hand, or the one before its call. */
  out(step: number, direction: Direction): number {
    return this.find(step, direction, this.depthAt(step) - 1);
  }

  private depthAt(step: number): number {
    return this.depths[step] ?? 1;
  }

  /** The nearest other step no deeper than that, or the end of the trace. */
  private find(from: number, direction: Direction, depth: number): number {
    const last = this.depths.length - 1;
    for (let step = from + direction; step >= 0 && step <= last; step += direction) {
      if (this.depthAt(step) <= depth) return step;
    }
    return direction === 1 ? last : 0;
  }
}
