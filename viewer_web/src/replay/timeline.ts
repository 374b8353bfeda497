import type { Event } from '../trace/events.js';
import type { Area, Header } from '../trace/header.js';
import { Store } from '../trace/store.js';
import type { Block } from '../trace/store.js';
import { Lines } from './lines.js';
import { modelOf } from './model.js';
import { hasRoomForDepths } from './screen.js';
import { State, depthChanges } from './state.js';
import type { Keyframe } from './state.js';
import { stretch } from './stretch.js';
import type { Uses } from './uses.js';

const mostKeyframes = 512;
const mostCells = 2 ** 25;
const least = 64;
/** Where a way was longer than twice this, its state so many steps before the goal is kept: one often goes back a little. */
const near = 2048;

/**
 * How many steps lie between the keyframes of a run: every other one goes when there are too many, or, since
 * each may have its own copy of the picture, too large ones.
 */
function spacing(length: number, { width, height }: Area): number {
  const most = Math.max(1, Math.min(mostKeyframes, Math.floor(mostCells / (width * height))));
  let every = least;
  while (length >= every * most) every *= 2;
  return every;
}

/** Whether a run that ends with this step has a keyframe there; all that a longer run has were such steps. */
export function hasKeyframe(step: number, area: Area): boolean {
  return step % least === 0 && step % spacing(step, area) === 0;
}

/**
 * The states of a trace, which may grow at its end. A seek, either way, starts at where it is or at the keyframe
 * before its goal, and applies of the events from there those that matter at the goal.
 */
export class Timeline {
  private readonly state: State;
  private readonly store = new Store();
  /** The lines that a run of curves draws. */
  readonly lines = new Lines(this.store);
  private readonly depthChanges: readonly number[];
  private readonly uses: Uses;
  private keyframes: readonly Keyframe[];
  private every = least;
  /** Before the goal of the last long way, in a run that has few keyframes. */
  private mark: Keyframe | null = null;

  constructor(private readonly header: Header) {
    this.state = new State(header);
    this.depthChanges = depthChanges(header.detail);
    this.uses = modelOf(header).uses;
    this.keyframes = [this.state.save()];
  }

  get length(): number {
    return this.store.length;
  }

  /** The numbers of the events' names, that of step n at n - 1: to go through a long run without its events. */
  get names(): Uint8Array {
    return this.store.names;
  }

  event(step: number): Event | null {
    return this.store.event(step);
  }

  /** The text that the event of a step came as. */
  line(step: number): string {
    return this.store.line(step);
  }

  /** The next lines of the trace, and keyframes among these: all whose step the spacing divides, or none at all. */
  append(block: Block, keyframes: readonly Keyframe[] = []): void {
    this.store.append(block);
    const every = spacing(this.length, this.header.scene.area);
    this.every = every;
    this.keyframes = [...this.keyframes, ...keyframes].filter(
      ({ values: { step } }) => step % every === 0,
    );
  }

  /** The state after the first `step` events. */
  seek(step: number): State {
    const now = this.state.values.step;
    const start = this.startOf(step);
    if (start !== undefined && (step < now || start.values.step > now)) this.state.load(start);
    if (step - this.state.values.step > 2 * near) {
      this.leap(step - near);
      this.mark = this.state.save();
    }
    this.leap(step);
    return this.state;
  }

  /** What is kept of the steps up to a goal, as near to it as there is. */
  private startOf(step: number): Keyframe | undefined {
    const { keyframes, mark } = this;
    const keyframe = keyframes[Math.floor(step / this.every)] ?? keyframes.at(-1);
    const at = mark?.values.step ?? Infinity;
    return mark !== null && at <= step && at > (keyframe?.values.step ?? 0) ? mark : keyframe;
  }

  private leap(step: number): void {
    const { step: begin } = this.state.values;
    if (step <= begin) return;
    const way = stretch(this.names, begin, step, this.depthChanges, this.uses);
    this.state.leap(way, (each) => this.existing(each));
  }

  private existing(step: number): Event {
    const { store } = this;
    const hasRoom = hasRoomForDepths(this.header.scene);
    const event = hasRoom ? store.event(step) : store.eventWithoutDepths(step);
    if (event === null) throw new RangeError(`step ${step} of ${this.length}`);
    return event;
  }
}
