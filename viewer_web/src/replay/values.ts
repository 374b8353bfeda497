import type {
  FloatingHorizonValues,
  Frame,
  WarnockValues,
  WeilerAthertonValues,
  ZBufferValues,
} from '../trace/event-table.js';
import type { Event } from '../trace/events.js';
import type { Box, Point } from '../trace/values.js';
import { engine } from './engine.js';

/** An entry (P, S) of a list of active polygons. */
export type Entry = readonly [polygon: string, surrounds: boolean];

/** A list of active polygons. Windows with the same list share the object. */
export interface Apl {
  readonly entries: readonly Entry[];
}

export interface StackedWindow {
  readonly window: Box;
  readonly apl: Apl;
}

/** What Warnock's algorithm holds, each window with its list. */
export interface Warnock extends Omit<WarnockValues, 'stack' | 'current' | 'contained'> {
  readonly contained: readonly (Event<'ray'> | Event<'octants'>)[];
  /** From bottom to top. */
  readonly stack: readonly StackedWindow[];
  readonly window: Box | null;
  readonly apl: Apl | null;
}

export interface WeilerAtherton extends Omit<WeilerAthertonValues, 'piercing'> {
  readonly piercing: Event<'pierce'> | null;
}

export interface FloatingHorizon extends Omit<FloatingHorizonValues, 'height'> {
  readonly height: Event<'height'> | null;
}

/** A visible part of a curve. */
export interface Line {
  readonly curve: number;
  readonly from: Point;
  readonly to: Point;
  /** The first and the last column under it. There are none if the last is less than the first. */
  readonly columns: readonly [first: number, last: number];
}

/** The values after a step, except for the cells of the screen. Values that did not change are the same objects. */
export interface Values {
  readonly step: number;
  readonly calls: readonly Frame[];
  readonly warnock?: Warnock;
  readonly zbuffer?: ZBufferValues;
  readonly weilerAtherton?: WeilerAtherton;
  readonly floatingHorizon?: FloatingHorizon;
  /** The lines that a run of curves has drawn. */
  readonly lines?: readonly Line[];
}

type Fields = Readonly<Record<string, unknown>>;

/** How a list differs from the one before: that many items stay, and these follow. */
interface Rest {
  readonly from: number;
  readonly rest: readonly unknown[];
}
const isRest = (value: unknown): value is Rest =>
  typeof value === 'object' && value !== null && 'rest' in value;

const isGroup = (value: unknown): value is Fields =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Values after news about some of them. Down to this depth, objects are groups of values. */
function after(old: Fields, news: Fields, depth: number): Fields {
  const changed: Record<string, unknown> = {};
  for (const [key, value] of Object.entries(news)) {
    if (isRest(value)) {
      const kept = (old[key] as readonly unknown[]).slice(0, value.from);
      changed[key] = [...kept, ...value.rest];
    } else if (depth > 0 && isGroup(value)) {
      changed[key] = after((old[key] ?? {}) as Fields, value, depth - 1);
    } else changed[key] = value;
  }
  return Object.keys(changed).length === 0 ? old : { ...old, ...changed };
}

/** The raw values of Warnock's algorithm: its lists are numbered. */
interface Raw extends Omit<Values, 'warnock'> {
  readonly warnock?: WarnockValues;
}
type News = Fields & { readonly lists?: Readonly<Record<string, Apl['entries']>> };

const mostLists = 1000;

/** The values of a run from the library: all at first, then those that differ from the ones before. */
export class ValueReader {
  private raw: Fields = {};
  private readonly lists = new Map<number, Apl>();
  private current: Values | null = null;
  private before: Values | null = null;

  /** The values after a step. */
  at(trace: number, step: number): Values {
    return this.before?.step === step ? this.before : this.goTo(trace, step);
  }

  /** Makes it the step whose screen the library shows. */
  goTo(trace: number, step: number): Values {
    if (this.current?.step === step) return this.current;
    engine().exports.trace_values(trace, step);
    const { lists = {}, ...news } = JSON.parse(engine().made()) as News;
    for (const [number, entries] of Object.entries(lists)) {
      this.lists.set(Number(number), { entries });
    }
    const old = this.raw['warnock'];
    this.raw = after(this.raw, news, 1);
    const { warnock, ...others } = this.raw as unknown as Raw;
    const isSame = warnock === old && Object.keys(lists).length === 0;
    this.before = this.current;
    const kept = isSame ? this.before?.warnock : undefined;
    this.current = warnock ? { ...others, warnock: kept ?? this.withLists(warnock) } : others;
    return this.current;
  }

  private withLists({ stack, current, contained, ...found }: WarnockValues): Warnock {
    const listed = ({ window, list }: WarnockValues['stack'][number]): StackedWindow => ({
      window,
      apl: this.lists.get(list) ?? { entries: [] },
    });
    const stacked = stack.map(listed);
    const now = current && listed(current);
    if (this.lists.size > mostLists) {
      const used = new Set([...stack, ...(current ? [current] : [])].map(({ list }) => list));
      for (const list of this.lists.keys()) if (!used.has(list)) this.lists.delete(list);
    }
    return {
      ...found,
      contained: contained as Warnock['contained'],
      stack: stacked,
      window: now?.window ?? null,
      apl: now?.apl ?? null,
    };
  }
}
