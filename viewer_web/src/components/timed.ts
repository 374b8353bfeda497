import { LitElement } from 'lit';
import type { PropertyValues } from 'lit';
import { property } from 'lit/decorators.js';
import type { Trace } from '../trace/trace.js';
import { Clock } from './clock.js';

/** What stands at a step of a trace, and may play from there. Each step that is shown is told by an event `vidno-step`. */
export class TimedElement extends LitElement {
  @property({ attribute: false }) trace: Trace | null = null;
  /** How many steps of the trace are there: more and more while it is read. */
  @property({ attribute: false }) length = 0;
  @property({ type: Number }) step = 0;
  readonly clock = new Clock(this, (steps) => this.advance(steps));

  togglePlay(): void {
    if (this.clock.playing) this.clock.stop();
    else {
      if (this.step >= this.length) this.step = 0;
      this.clock.start();
    }
  }

  moveTo(step: number): void {
    this.clock.stop();
    this.step = this.clamped(step);
  }

  private advance(steps: number): void {
    if (steps > 0) this.step = this.clamped(this.step + steps);
    if (this.step >= this.length && this.trace?.complete !== false) this.clock.stop();
  }

  protected clamped(step: number): number {
    return Math.min(Math.max(0, Math.trunc(step) || 0), this.length);
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('trace')) this.clock.stop();
    this.step = this.clamped(this.step);
  }

  override updated(changed: PropertyValues<this>): void {
    if (changed.has('step') || changed.has('trace')) {
      this.dispatchEvent(new CustomEvent('vidno-step', { detail: this.step }));
    }
  }
}
