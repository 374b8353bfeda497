import type { Event } from '../trace/events.js';
import type { Header, Scene } from '../trace/header.js';
import { Store } from '../trace/store.js';
import type { Block } from '../trace/store.js';
import { Lines } from './lines.js';
import { modelOf } from './model.js';
import { hasRoomForDepths } from './screen.js';
import { State, depthChanges } from './state.js';
import type { Keyframe, Values } from './state.js';
import { stretch } from './stretch.js';
import type { Uses } from './uses.js';

const mostKeyframes = 512;
const mostCells = 2 ** 25;
const least = 64;
/** The list entries that a keyframe may have for each step that it saves. */
const mostListed = 16;
/** The number of steps between two looks at the clock. */
const stride = 2048;
/** The bytes of lines in a seek above which it is done in strides. */
const far = 2 ** 22;
/**
 * The state this many bytes before a goal is kept if the seek was twice as long, because readers often go back a little.
 */
const near = 2 ** 17;
/** If fewer than one event in this many is relevant, decoding their lines alone is quicker than decoding whole blocks. */
const sparse = 8;

/**
 * The number of steps between the keyframes of a run. Every other keyframe is dropped when there are too many, or when they
 * are too large: each may have its own copy of the picture and of a list of all polygons.
 */
function spacing(length: number, { area: { width, height }, polygons }: Scene): number {
  const most = Math.max(1, Math.min(mostKeyframes, Math.floor(mostCells / (width * height))));
  let every = least;
  while (length >= every * most || polygons.length > every * mostListed) every *= 2;
  return every;
}

/**
 * The states of a trace, which may grow at its end. A seek in either direction starts at the current state or at the
 * keyframe before its goal, and applies the relevant events from there.
 */
export class Timeline {
  private readonly state: State;
  private readonly store = new Store();
  /** The lines that a run of curves draws. */
  readonly lines = new Lines(this.store);
  private readonly depthChanges: readonly number[];
  private readonly uses: Uses;
  /** The keyframes at the multiples of the spacing, from 0 on, as far as the run was replayed. */
  private keyframes: Keyframe[];
  private every = least;
  /** A state before the goal of the last long seek. */
  private mark: Keyframe | null = null;
  /** Goes to other steps, while the current state stays. */
  private scout: State | null = null;

  constructor(private readonly header: Header) {
    this.state = new State(header);
    this.depthChanges = depthChanges(header.detail);
    this.uses = modelOf(header).uses;
    this.keyframes = [this.state.save()];
  }

  get length(): number {
    return this.store.length;
  }

  /** The numbers of the events' names, for passes over a long run without its events. That of step n is at n - 1. */
  get names(): Uint8Array {
    return this.store.names;
  }

  event(step: number): Event | null {
    return this.store.event(step);
  }

  /** The same, but quick for any step of a long run. */
  eventAlone(step: number): Event | null {
    return this.store.eventAlone(step);
  }

  /** The text of a step's event as it was read. */
  line(step: number): string {
    return this.store.line(step);
  }

  /** Adds the next lines of the trace. */
  append(block: Block): void {
    this.store.append(block);
    const every = spacing(this.length, this.header.scene);
    if (every === this.every) return;
    this.every = every;
    this.keyframes = this.keyframes.filter(({ values: { step } }) => step % every === 0);
  }

  /** The state after the first `step` events. */
  seek(step: number): State {
    this.approach(step);
    const { state } = this;
    const start = this.startOf(step);
    if (start !== null) state.load(start);
    this.leap(state, step);
    return state;
  }

  /** The values after the first `step` events, while the current state stays. */
  valuesAt(step: number): Values {
    const scout = this.scoutAt(this.startOf(step), step);
    this.leap(scout, step);
    return scout.values;
  }

  /**
   * Goes a part of the way to a step, for about this time, and returns the number of steps left. At 0 a seek is quick.
   * Keeps keyframes on the way.
   */
  approach(step: number, milliseconds = Infinity): number {
    const start = this.startOf(step);
    const { store } = this;
    const begin = start?.values.step ?? this.state.step;
    const bytes = store.bytesBefore(step) - store.bytesBefore(begin);
    // A single leap skips most of the events on the way.
    const isLeap = bytes <= far;
    if (bytes <= 2 * near || (isLeap && start === null)) return 0;
    const goal = store.stepAt(store.bytesBefore(step) - near);
    const scout = this.scoutAt(start, goal);
    const end = performance.now() + milliseconds;
    if (isLeap) this.leap(scout, goal);
    // Each call gets on, even if the machine stood still.
    while (scout.step < goal) {
      this.stride(scout, goal);
      if (performance.now() >= end) return goal - scout.step;
    }
    this.mark = scout.save();
    return 0;
  }

  /** Keeps further keyframes, for about this time, and returns whether it has all. Then a seek to any step is quick. */
  ripen(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    while (this.next <= this.length) {
      if (performance.now() >= end) return false;
      const last = this.keyframes.at(-1);
      if (last === undefined) throw new Error('no keyframe of the beginning');
      this.stride(this.scoutAt(last, this.next - 1), this.next);
    }
    return true;
  }

  /** The step of the next keyframe to keep. */
  private get next(): number {
    return this.keyframes.length * this.every;
  }

  /** The scout, where it is if that is between two steps, or else at the first: a keyframe, or null for the current state. */
  private scoutAt(start: Keyframe | null, end: number): State {
    this.scout ??= new State(this.header);
    const { step } = this.scout;
    const begin = start?.values.step ?? this.state.step;
    if (step < begin || step > end) this.scout.load(start ?? this.state.save());
    return this.scout;
  }

  private stride(scout: State, goal: number): void {
    const { step } = scout;
    const { next } = this;
    const stop = step < next ? Math.min(goal, next) : goal;
    this.leap(scout, Math.min(stop, step + stride, this.store.endOfBlock(step + 1)));
    if (scout.step === next) this.keyframes.push(scout.save());
  }

  /** The nearest stored state before a goal; null if the current state is nearer. */
  private startOf(step: number): Keyframe | null {
    const { keyframes, mark, state } = this;
    const keyframe = keyframes[Math.min(Math.floor(step / this.every), keyframes.length - 1)];
    const stepOf = (kept: Keyframe | null | undefined): number => {
      const at = kept?.values.step ?? Infinity;
      return at <= step ? at : -1;
    };
    const nearest = stepOf(mark) > stepOf(keyframe) ? mark : (keyframe ?? null);
    return state.step <= step && state.step >= stepOf(nearest) ? null : nearest;
  }

  private leap(state: State, step: number): void {
    if (step <= state.step) return;
    const way = stretch(this.names, state.step, step, this.depthChanges, this.uses);
    const isSparse = way.changes.length * sparse < step - state.step;
    const read = (each: number): Event => {
      const event = this.replayed(each, isSparse);
      if (event === null) throw new RangeError(`step ${each} of ${this.length}`);
      return event;
    };
    const isQuick = isSparse && hasRoomForDepths(this.header.scene);
    const changes = isQuick ? this.store.eventsAlone(way.changes) : way.changes.map(read);
    state.leap(way, changes, read);
  }

  /** The event of a step, as far as the state stores its values. */
  private replayed(step: number, isSparse: boolean): Event | null {
    const { store } = this;
    if (!hasRoomForDepths(this.header.scene)) return store.eventWithoutDepths(step);
    return isSparse ? store.eventAlone(step) : store.event(step);
  }
}
