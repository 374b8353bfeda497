import { noted, test } from '../history/entry.js';
import type { Outcome, Watch } from '../history/entry.js';
import type { Known } from '../language/words.js';
import type { Pixel } from '../picture/pixel.js';
import type { Values } from '../replay/values.js';
import { only } from '../replay/wanted.js';
import type { Wanted } from '../replay/wanted.js';
import type { Detail, Event, EventName } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { emptyFloatingHorizon, isLostBelow } from './state.js';

type Judge<K extends EventName> = (event: Event<K>, x: number) => Outcome | null;

const over = ({ x: column }: { readonly x: number }, x: number): Outcome | null =>
  noted(column === x);
const isAmong = (changes: readonly (readonly [number, unknown])[], x: number): boolean =>
  changes.some(([column]) => column === x);

const judges: { readonly [K in EventName]?: Judge<K> } = {
  height: over,
  draw_line: ({ fromColumns, toColumns }, x) =>
    fromColumns[1] <= x && x <= toColumns[0] ? 'paint' : null,
  intersection: ({ columns: [left, right] }, x) => noted(left <= x && x <= right),
  horizon: ({ upper, lower }, x) => noted(isAmong(upper, x) || isAmong(lower, x)),
  raise: over,
  lower: over,
  step: over,
};

const always = ['visibility', 'draw_line', 'intersection', 'disagree'] as const;
/** The events to watch at each level. At the highest level each change of a horizon has an event of its own. */
const wantedAt: Readonly<Record<Detail, Wanted>> = {
  windows: only(...always),
  polygons: only(...always, 'horizon'),
  signs: only(...always, 'height', 'raise', 'lower', 'step'),
};

const columnOf = /"x":(-?\d+)[,}]/;

/** The history of a column: every curve's height and flag, the lines, and the changes of the horizons. */
export class ColumnWatch implements Watch {
  readonly wanted: Wanted;
  private readonly x: number;
  private step = 0;
  private toldAt = 0;

  constructor(
    [x]: Pixel,
    private readonly header: Pick<Header, 'detail' | 'edition'>,
    private readonly valuesAt: (step: number) => Values,
  ) {
    this.x = x;
    this.wanted = wantedAt[header.detail];
  }

  get known(): Known {
    const { curve, place, height } =
      this.valuesAt(this.step).floatingHorizon ?? emptyFloatingHorizon;
    return { floatingHorizon: { curve, place, height } };
  }

  /** Skips events of other columns. */
  isElsewhere(line: string): boolean {
    const found = columnOf.exec(line);
    return found !== null && Number(found[1]) !== this.x;
  }

  see(event: Event, step: number): Outcome | null {
    this.step = step;
    if (event.e === 'disagree') return this.toldAt === step - 1 ? 'wrong' : null;
    const judge = judges[event.e] as Judge<EventName> | undefined;
    const outcome = event.e === 'visibility' ? this.look(event) : (judge?.(event, this.x) ?? null);
    if (outcome !== null) this.toldAt = step;
    return outcome;
  }

  /** The outcome of Visibility: whether the curve is visible. */
  private look({ x, flag }: Event<'visibility'>): Outcome | null {
    if (x !== this.x) return null;
    return isLostBelow(flag, this.header.edition) ? 'note' : test(flag !== 0);
  }
}
