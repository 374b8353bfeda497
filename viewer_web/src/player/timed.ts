import { LitElement } from 'lit';
import type { PropertyValues } from 'lit';
import { property } from 'lit/decorators.js';
import { isSpeed } from '../base/setting.js';
import { Clock } from '../elements/clock.js';
import type { Trace } from '../replay/trace.js';
import type { Command } from '../time/travel.js';

/** An element at a step of a trace, which can play from there. An event `vidno-step` reports each new step. */
export class TimedElement extends LitElement {
  @property({ attribute: false }) trace: Trace | null = null;
  /** The number of steps read so far. */
  @property({ attribute: false }) length = 0;
  /** Whether all steps are read; for two runs, those of both. */
  @property({ type: Boolean }) complete = false;
  @property({ type: Number }) step = 0;
  /** The first and the last reachable step; null is the last step of the trace. */
  @property({ type: Number }) from = 0;
  @property({ type: Number }) to: number | null = null;
  /** Steps per second, from 0.1 to 1000; null keeps the current speed. */
  @property({ type: Number }) speed: number | null = null;
  /** Whether the first trace plays immediately, unless the reader prefers reduced motion. */
  @property({ type: Boolean }) play = false;
  readonly clock = new Clock(this, (steps) => this.advance(steps));

  get first(): number {
    return Math.min(Math.max(0, Math.trunc(this.from) || 0), this.length);
  }

  get last(): number {
    const to = Math.trunc(this.to ?? this.length);
    return Math.max(this.first, Math.min(Number.isNaN(to) ? this.length : to, this.length));
  }

  /** The last step that the player may show now. */
  protected get limit(): number {
    return this.last;
  }

  /** Whether there are steps that cannot be reached. */
  get isBounded(): boolean {
    return this.first > 0 || this.last < this.length;
  }

  togglePlay(): void {
    if (this.clock.playing) this.clock.stop();
    else {
      if (this.step >= this.last) this.step = this.first;
      this.clock.start();
    }
  }

  /** Carries out a command of the time controls. */
  protected steer(command: Command): void {
    if (command.do === 'play') this.togglePlay();
    else if (command.do === 'speed') this.clock.speed = command.speed;
    else if (command.do === 'seek') this.moveTo(command.step);
  }

  moveTo(step: number): void {
    this.clock.stop();
    this.step = this.clamped(step);
  }

  private advance(steps: number): void {
    if (steps > 0) this.step = this.clamped(this.step + steps);
    const isLast = this.step >= this.limit;
    if (isLast && (this.limit < this.length || this.trace?.complete !== false)) this.clock.stop();
  }

  protected clamped(step: number): number {
    return Math.min(Math.max(this.first, Math.trunc(step) || 0), this.limit);
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('trace')) this.clock.stop();
    if (changed.has('speed') && isSpeed(this.speed)) this.clock.speed = this.speed;
    if (this.trace === null) return;
    this.step = this.clamped(this.step);
    if (this.play) this.begin();
  }

  private begin(): void {
    this.play = false;
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) this.clock.start();
  }

  override updated(changed: PropertyValues<this>): void {
    if (changed.has('step') || changed.has('trace')) {
      this.dispatchEvent(new CustomEvent('vidno-step', { detail: this.step }));
    }
  }
}
