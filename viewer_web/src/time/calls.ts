import type { Trace } from '../replay/trace.js';
import { depthChanges } from '../trace/events.js';

export type Direction = -1 | 1;

/** The call depth after each step, and the steps over and out of procedures, in both directions. */
export class Calls {
  private readonly depths: Uint8Array;

  constructor({ header, timeline: { names } }: Trace) {
    const changes = depthChanges(header.detail);
    this.depths = new Uint8Array(names.length + 1);
    this.depths[0] = 1;
    for (let i = 0; i < names.length; i++) {
      this.depths[i + 1] = this.depthAt(i) + (changes[names[i] ?? 0] ?? 0);
    }
  }

  get length(): number {
    return this.depths.length - 1;
  }

  /** The next step, where a call with everything in it counts as one step. */
  over(step: number, direction: Direction): number {
    return this.find(step, direction, this.depthAt(step));
  }

  /** The step that ends the current procedure, or the one before its call. */
  out(step: number, direction: Direction): number {
    return this.find(step, direction, this.depthAt(step) - 1);
  }

  private depthAt(step: number): number {
    return this.depths[step] ?? 1;
  }

  /** The nearest other step at most at this depth, or the end of the trace. */
  private find(from: number, direction: Direction, depth: number): number {
    const last = this.length;
    for (let step = from + direction; step >= 0 && step <= last; step += direction) {
      if (this.depthAt(step) <= depth) return step;
    }
    return direction === 1 ? last : 0;
  }
}
