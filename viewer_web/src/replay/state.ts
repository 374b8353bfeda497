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

/** A procedure that runs, and the label that it is at. */
export interface Frame {
  /** As its listing is called. */
  readonly of: string;
  readonly at: string | null;
}

/** What a step leaves behind, the cells of picture and Z-buffer apart. */
export interface Values extends Held {
  readonly step: number;
  readonly calls: readonly Frame[];
}

/** All that a state is, as plain data. */
export interface Keyframe {
  readonly values: Values;
  readonly screen: SavedScreen;
  readonly columns: SavedColumns | null;
}

/** By how much each event, at the number of its name, changes the depth of the calls. */
export function depthChanges(detail: Detail): readonly number[] {
  return eventNames.map((name) => (name === 'call' ? 1 : closedBy(name, detail) === null ? 0 : -1));
}

/** The procedure that an event ends: below the level of its call a result closes nothing. */
function closedBy(name: EventName, detail: Detail): Procedure | null {
  const { resultOf } = kinds[name];
  if (resultOf === undefined) return null;
  return details.indexOf(detail) >= details.indexOf(callsFrom[resultOf]) ? resultOf : null;
}

/** Everything at a step. Its values are immutable, so that a keyframe shares what does not change. */
export class State {
  readonly screen: Screen;
  /** Null of a run of polygons. */
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

  /** How many events were taken. */
  get step(): number {
    return this.taken;
  }

  get values(): Values {
    const { step, calls, hand } = this;
    return { step, calls, ...hand.held };
  }

  /** The event of a step, at least the next that changes anything; one that cannot happen here is refused. */
  apply(event: Event, step = this.taken + 1): void {
    this.change(event);
    this.pass(event.e);
    this.calls = movedBy(event, this.calls);
    this.taken = step;
  }

  /** The same of a state of which only what refuses events is ever looked at. */
  check(event: Event): void {
    this.change(event);
    if (event.e === 'call') this.calls = movedBy(event, this.calls);
    else this.pass(event.e);
  }

  /** Past an event that only ends a procedure, or changes nothing at all: the next one that is applied sets the line. */
  pass(name: EventName): void {
    const closed = closedBy(name, this.header.detail);
    if (closed === null) return;
    const top = this.calls.at(-1)?.of ?? '';
    if (top !== closed) throw new Refusal('e', 'resultOf', closed, top);
    this.calls = this.calls.slice(0, -1);
  }

  /** Goes on to the end of a stretch by those of its events that matter there. */
  leap({ end, changes, closed, opened }: Stretch, eventOf: (step: number) => Event): void {
    for (const step of changes) this.change(eventOf(step));
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

  private change(event: Event): void {
    if ('polygon' in event) this.screen.polygon(event.polygon);
    this.hand.take(event, this);
  }
}

/** An event sets the line of the current procedure; a call opens the frame of another. */
function movedBy(event: Event, calls: readonly Frame[]): readonly Frame[] {
  const top = calls.at(-1);
  if (top === undefined || (top.at === event.at && event.e !== 'call')) return calls;
  const moved = [...calls.slice(0, -1), { of: top.of, at: event.at }];
  return event.e === 'call' ? [...moved, { of: event.of, at: null }] : moved;
}
