import type { Detail, Event, Method } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import type { Columns } from './columns.js';
import type { Line } from './lines.js';
import type { Screen } from './screen.js';
import type { Uses } from './uses.js';

/**
 * The values of a run at a step, each algorithm's under a name of its own. Values are immutable, so that keyframes share
 * what does not change. The algorithms add their parts by `declare module`; the parts of other algorithms are undefined.
 */
// eslint-disable-next-line @typescript-eslint/no-empty-object-type
export interface Held {}

/** What events write to: pixels, and in a run of curves the columns of the area. */
export interface Paper {
  readonly screen: Screen;
  readonly columns: Columns | null;
}

/** The changing values of one run as it goes from event to event. */
export interface Hand {
  readonly held: Held;
  /** Applies an event; throws if it cannot happen here. */
  take(event: Event, paper: Paper): void;
  /** Restores the values of a keyframe. */
  load(held: Held): void;
}

/** A state in the form in which readers of a trace are compared. */
export interface Compared extends Paper {
  readonly held: Held;
  readonly method: Method;
  readonly detail: Detail;
  readonly lines: readonly Line[];
}

/** How the runs of an algorithm change their values. */
export interface Model {
  begin(header: Header): Hand;
  readonly uses: Uses;
  compared(state: Compared): object;
}

/** A hand with a single value, which each event replaces. */
export class ValueInHand<K extends keyof Held> implements Hand {
  constructor(
    private readonly name: K,
    private value: NonNullable<Held[K]>,
    private readonly after: (
      event: Event,
      now: NonNullable<Held[K]>,
      paper: Paper,
    ) => NonNullable<Held[K]>,
  ) {}

  get held(): Held {
    return { [this.name]: this.value };
  }

  take(event: Event, paper: Paper): void {
    this.value = this.after(event, this.value, paper);
  }

  load(held: Held): void {
    this.value = held[this.name] ?? this.value;
  }
}

const models = new Map<Method, Model>();

/** Registers the model of these methods; each algorithm does so once, when the page loads. */
export function defineModel(methods: readonly Method[], model: Model): void {
  for (const method of methods) models.set(method, model);
}

export function modelOf({ method }: Pick<Header, 'method'>): Model {
  const model = models.get(method);
  if (model === undefined) throw new Error(`no model of ${method} was defined`);
  return model;
}
