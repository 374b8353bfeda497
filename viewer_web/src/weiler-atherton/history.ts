import { covers, noted, test } from '../history/entry.js';
import type { Outcome, Watch } from '../history/entry.js';
import { toNumber } from '../language/words.js';
import type { Known } from '../language/words.js';
import type { Spot } from '../picture/mark.js';
import type { Pixel } from '../picture/pixel.js';
import type { Values, WeilerAtherton } from '../replay/values.js';
import { only } from '../replay/wanted.js';
import type { Event, EventName } from '../trace/events.js';
import type { Piece, Region } from '../trace/values.js';
import { holds } from './geometry.js';
import { emptyWeilerAtherton } from './state.js';

/** The pixel, and the values before the event. */
interface Place {
  readonly pixel: Pixel;
  readonly centre: Spot;
  before(): WeilerAtherton;
}

const isOver = (region: Region, { centre }: Place): boolean => holds(region, centre);
const isAnyOver = (pieces: readonly Piece[], place: Place): boolean =>
  pieces.some(([, region]) => isOver(region, place));

type Judge<K extends EventName> = (event: Event<K>, place: Place) => Outcome | null;

const judges: { readonly [K in EventName]?: Judge<K> } = {
  cut_to_area: ({ region }, place) => noted(isOver(region, place)),
  split: ({ region, other }, place) => noted(isOver(region, place) || isOver(other, place)),
  pop_list: (_event, place) => noted(isAnyOver(place.before().lists.at(-1) ?? [], place)),
  beside: (_event, place) => {
    const { pieces, seen } = place.before().inHand ?? { pieces: [], seen: 0 };
    return noted(isAnyOver(pieces.slice(seen, seen + 1), place));
  },
  clipped: ({ at, inside, outside }, place) => {
    if (at === 'SP1' || !(isOver(inside, place) || isOver(outside, place))) return null;
    return test(isOver(inside, place));
  },
  behind: ({ behind }, place) => {
    const { inside, behind: seen } = place.before().inHand ?? { inside: [], behind: [] };
    const part = inside.filter(([, , ground]) => !ground)[seen.length];
    return part !== undefined && isOver(part[1], place) ? test(!behind) : null;
  },
  show: ({ region }, place) => (isOver(region, place) ? 'pass' : null),
  order: ({ point, order }, { centre }) =>
    point.every((value, i) => toNumber(value) === centre[i]) ? test(order > 0) : null,
  paint: ({ runs }, { pixel: [x, y] }) =>
    covers(
      runs.filter(([row]) => row === y).map(([, first, end]) => [first, end] as const),
      x,
    )
      ? 'paint'
      : null,
};

const wanted = only('disagree', ...(Object.keys(judges) as EventName[]));

/** The history of a pixel: the pieces over its centre, what clips them, what is behind, and the visible region. */
export class RegionWatch implements Watch {
  readonly wanted = wanted;
  private readonly centre: Spot;
  private step = 0;
  private toldAt = 0;

  constructor(
    private readonly pixel: Pixel,
    private readonly valuesAt: (step: number) => Values,
  ) {
    this.centre = [pixel[0] + 0.5, pixel[1] + 0.5];
  }

  get known(): Known {
    const { inHand } = this.regionsAt(this.step);
    return { weilerAtherton: { inHand } };
  }

  see(event: Event, step: number): Outcome | null {
    this.step = step;
    const outcome = this.judge(event);
    if (outcome !== null) this.toldAt = step;
    return outcome;
  }

  private judge(event: Event): Outcome | null {
    const { pixel, centre, step } = this;
    if (event.e === 'disagree') return this.toldAt === step - 1 ? 'wrong' : null;
    const judge = judges[event.e] as Judge<EventName> | undefined;
    return judge?.(event, { pixel, centre, before: () => this.regionsAt(step - 1) }) ?? null;
  }

  private regionsAt(step: number): WeilerAtherton {
    return this.valuesAt(step).weilerAtherton ?? emptyWeilerAtherton;
  }
}
