import { cutsAnywhere, firstProcedure } from '../trace/editions.js';
import { callsFrom, details, eventNames, kinds } from '../trace/events.js';
import type { Detail, Event, EventName, Procedure } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import { Columns } from './columns.js';
import type { SavedColumns } from './columns.js';
import { modelOf } from './model.js';
import type { Hand, Held } from './model.js';
import { Screen, keepsDepths } from './screen.js';
import type { SavedScreen } from './screen.js';
import type { Stretch } from './stretch.js';

/** A running procedure, and its current label. */
export interface Frame {
  /** The name of its listing. */
  readonly of: string;
  readonly at: string | null;
}

/** The values after a step, except for the cells of picture and Z-buffer. */
export interface Values extends Held {
  readonly step: number;
  readonly calls: readonly Frame[];
}

/** A whole state as plain data. */
export interface Keyframe {
  readonly values: Values;
  readonly screen: SavedScreen;
  readonly columns: SavedColumns | null;
}

/** The change in call depth of each event, by the number of its name. */
export function depthChanges(detail: Detail): readonly number[] {
  return eventNames.map((name) => (name === 'call' ? 1 : closedBy(name, detail) === null ? 0 : -1));
}

/** The procedure that an event ends. At a level without calls a result ends nothing. */
function closedBy(name: EventName, detail: Detail): Procedure | null {
  const { resultOf } = kinds[name];
  if (resultOf === undefined) return null;
  return details.indexOf(detail) >= details.indexOf(callsFrom[resultOf]) ? resultOf : null;
}

/** The state at a step. Its values are immutable, so that a keyframe shares what does not change. */
export class State {
  readonly screen: Screen;
  /** Null for a run of polygons. */
  readonly columns: Columns | null;
  private taken = 0;
  private calls: readonly Frame[];
  private readonly hand: Hand;

  constructor(
    private readonly header: Header,
    screen?: Screen,
  ) {
    const { method, scene } = header;
    this.screen = screen ?? new Screen(scene, keepsDepths(header), cutsAnywhere(method));
    this.columns = scene.curves === null ? null : new Columns(scene);
    this.calls = [{ of: firstProcedure(method), at: null }];
    this.hand = modelOf(header).begin(header);
  }

  /** The number of events applied. */
  get step(): number {
    return this.taken;
  }

  get values(): Values {
    const { step, calls, hand } = this;
    return { step, calls, ...hand.held };
  }

  /**
   * Applies the event of a step. Events between that change nothing may be skipped. Throws if the event cannot happen here.
   */
  apply(event: Event, step = this.taken + 1): void {
    this.change(event, step);
    this.pass(event.e);
    this.calls = movedBy(event, this.calls);
    this.taken = step;
  }

  /** The same, if the state is only used to check events. */
  check(event: Event): void {
    this.change(event, 0);
    if (event.e === 'call') this.calls = movedBy(event, this.calls);
    else this.pass(event.e);
  }

  /** Passes an event that only ends a procedure, or changes nothing. The next applied event sets the line. */
  pass(name: EventName): void {
    const closed = closedBy(name, this.header.detail);
    if (closed === null) return;
    const top = this.calls.at(-1)?.of ?? '';
    if (top !== closed) throw new Refusal('e', 'resultOf', closed, top);
    this.calls = this.calls.slice(0, -1);
  }

  /** Continues to the end of a stretch by applying the events of its changes, in the same order. */
  leap(
    { end, changes, closed, opened }: Stretch,
    changing: readonly Event[],
    eventOf: (step: number) => Event,
  ): void {
    changing.forEach((event, i) => this.change(event, changes[i] ?? end));
    this.calls = this.calls.slice(0, this.calls.length - closed);
    const last = opened.at(-1) === end ? [] : [end];
    for (const step of [...opened, ...last]) this.calls = movedBy(eventOf(step), this.calls);
    this.taken = end;
  }

  save(): Keyframe {
    const { values, screen, columns } = this;
    return { values, screen: screen.save(), columns: columns?.save() ?? null };
  }

  load({ values, screen, columns }: Keyframe): void {
    ({ step: this.taken, calls: this.calls } = values);
    this.hand.load(values);
    this.screen.load(screen);
    if (columns !== null) this.columns?.load(columns);
  }

  private change(event: Event, step: number): void {
    this.screen.step = step;
    if ('polygon' in event) this.screen.polygon(event.polygon);
    this.hand.take(event, this);
  }
}

/** An event sets the line of the current procedure; a call pushes a frame. */
function movedBy(event: Event, calls: readonly Frame[]): readonly Frame[] {
  const top = calls.at(-1);
  if (top === undefined || (top.at === event.at && event.e !== 'call')) return calls;
  const moved = [...calls.slice(0, -1), { of: top.of, at: event.at }];
  return event.e === 'call' ? [...moved, { of: event.of, at: null }] : moved;
}
