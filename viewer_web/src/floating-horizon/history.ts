import { noted, test } from '../history/entry.js';
import type { Outcome, Watch } from '../history/entry.js';
import type { Known } from '../language/words.js';
import type { Pixel } from '../picture/pixel.js';
import { only } from '../replay/wanted.js';
import type { Wanted } from '../replay/wanted.js';
import type { Edition } from '../trace/editions.js';
import type { FloatingHorizonEvents, Detail, Event } from '../trace/events.js';
import { isLostBelow } from './sides.js';
import { emptyFloatingHorizon, placeAfter } from './state.js';
import type { FloatingHorizon } from './state.js';

type Judge<K extends keyof FloatingHorizonEvents> = (
  event: FloatingHorizonEvents[K],
  x: number,
) => Outcome | null;

const over = ({ x: column }: { readonly x: number }, x: number): Outcome | null =>
  noted(column === x);
const isAmong = (changes: readonly (readonly [number, unknown])[], x: number): boolean =>
  changes.some(([column]) => column === x);

const judges: { readonly [K in keyof FloatingHorizonEvents]?: Judge<K> } = {
  height: over,
  draw_line: ({ fromColumns, toColumns }, x) =>
    fromColumns[1] <= x && x <= toColumns[0] ? 'paint' : null,
  intersection: ({ columns: [left, right] }, x) => noted(left <= x && x <= right),
  horizon: ({ upper, lower }, x) => noted(isAmong(upper, x) || isAmong(lower, x)),
  raise: over,
  lower: over,
  step: over,
};

const always = ['curve', 'visibility', 'draw_line', 'intersection', 'disagree'] as const;
/** The events to watch at each level. At the highest level each change of a horizon has an event of its own. */
const wantedAt: Readonly<Record<Detail, Wanted>> = {
  windows: only(...always),
  polygons: only(...always, 'horizon'),
  signs: only(...always, 'height', 'raise', 'lower', 'step'),
};

const visibility = '{"e":"visibility"';
const columnOf = /"x":(-?\d+)[,}]/;

/** The history of a column: every curve's height and flag, the lines, and the changes of the horizons. */
export class ColumnWatch implements Watch {
  readonly wanted: Wanted;
  private readonly x: number;
  private horizon: FloatingHorizon = emptyFloatingHorizon;
  private toldAt = 0;

  constructor(
    [x]: Pixel,
    detail: Detail,
    private readonly edition: Edition,
  ) {
    this.x = x;
    this.wanted = wantedAt[detail];
  }

  get known(): Known {
    return { floatingHorizon: this.horizon };
  }

  /** Skips events of other columns, except those of Visibility, which determine the horizon that a segment meets. */
  isElsewhere(line: string): boolean {
    if (line.startsWith(visibility)) return false;
    const found = columnOf.exec(line);
    return found !== null && Number(found[1]) !== this.x;
  }

  /** Records a result of Visibility. For this column it is also the outcome: whether the curve is visible. */
  private look(event: Event<'visibility'>): Outcome | null {
    const { horizon, edition } = this;
    this.horizon = { ...horizon, place: placeAfter(event, horizon.place) };
    if (event.x !== this.x) return null;
    return isLostBelow(event.flag, edition) ? 'note' : test(event.flag !== 0);
  }

  see(event: Event, step: number): Outcome | null {
    if (event.e === 'curve') this.horizon = { ...emptyFloatingHorizon, curve: event.curve };
    if (event.e === 'height' && event.x === this.x) this.horizon = { ...this.horizon, told: event };
    if (event.e === 'disagree') return this.toldAt === step - 1 ? 'wrong' : null;
    const judge = (judges as Readonly<Partial<Record<string, Judge<keyof FloatingHorizonEvents>>>>)[
      event.e
    ];
    const outcome =
      event.e === 'visibility'
        ? this.look(event)
        : (judge?.(event as FloatingHorizonEvents[keyof FloatingHorizonEvents], this.x) ?? null);
    if (outcome !== null) this.toldAt = step;
    return outcome;
  }
}
