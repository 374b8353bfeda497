import { numberOf } from '../trace/events.js';
import type { Event } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { State } from './state.js';
import type { Keyframe } from './state.js';

const mostKeyframes = 512;

/**
 * The states of a trace. While it is being read each event is applied and now and then a keyframe is kept, so
 * that a seek, either way, starts at the keyframe before its goal. When there are too many keyframes, every
 * other one goes.
 */
export class Timeline {
  readonly state: State;
  private readonly events: Event[] = [];
  private readonly numbers: number[] = [];
  private keyframes: Keyframe[];
  private every = 64;
  /** A large picture may be copied with each keyframe: keep fewer. */
  private readonly most: number;

  constructor(header: Header) {
    const { width, height } = header.scene.area;
    this.state = new State(header);
    this.keyframes = [this.state.save()];
    this.most = Math.max(8, Math.min(mostKeyframes, Math.floor(2 ** 27 / (width * height))));
  }

  get length(): number {
    return this.events.length;
  }

  event(step: number): Event | null {
    return this.events[step - 1] ?? null;
  }

  /** The numbers of the events' names, that of step n at n - 1: to go through a long run without its events. */
  get names(): readonly number[] {
    return this.numbers;
  }

  /** The next event of the trace; the state must be at its end. */
  append(event: Event): void {
    this.state.apply(event);
    this.events.push(event);
    this.numbers.push(numberOf.get(event.e) ?? 0);
    if (this.events.length % this.every === 0) this.keep();
  }

  /** The state after the first `step` events. */
  seek(step: number): State {
    const now = this.state.values.step;
    const keyframe = this.keyframes[Math.floor(step / this.every)];
    if (keyframe !== undefined && (step < now || keyframe.values.step > now)) {
      this.state.load(keyframe);
    }
    for (let i = this.state.values.step; i < step; i++) {
      const event = this.events[i];
      if (event !== undefined) this.state.apply(event);
    }
    return this.state;
  }

  private keep(): void {
    this.keyframes.push(this.state.save());
    if (this.keyframes.length <= this.most) return;
    this.keyframes = this.keyframes.filter((_, i) => i % 2 === 0);
    this.every *= 2;
  }
}
