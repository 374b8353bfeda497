import { covers, test } from '../history/entry.js';
import type { Outcome, Watch } from '../history/entry.js';
import type { Known } from '../language/words.js';
import type { Pixel } from '../picture/pixel.js';
import { only } from '../replay/wanted.js';
import type { Wanted } from '../replay/wanted.js';
import type { Event, EventName } from '../trace/events.js';

interface Place {
  readonly x: number;
  readonly y: number;
  /** Whether ShowLine is on the pixel's row. */
  onRow: boolean;
  /** The last step that concerned the pixel. */
  toldAt: number;
}

type Judge<K extends EventName> = (event: Event<K>, place: Place, step: number) => Outcome | null;

const judges: { readonly [K in EventName]?: Judge<K> } = {
  clear: () => 'paint',
  line: ({ row }, { y }) => (row === y ? 'note' : null),
  miss: (_event, { onRow }) => (onRow ? 'fail' : null),
  columns: ({ first, end }, { x, onRow }) => (onRow ? test(covers([[first, end]], x)) : null),
  pixel: (event, { x, y }) => (event.x === x && event.y === y ? test(event.shown) : null),
  span: ({ row, runs }, { x, y }) => {
    if (row !== y) return null;
    return covers(runs, x) ? 'paint' : 'fail';
  },
  disagree: (_event, { toldAt }, step) => (toldAt === step - 1 ? 'wrong' : null),
  fault: (event, { x, y }) => (event.x === x && event.y === y ? 'wrong' : null),
};

const always = ['clear', 'polygon', 'line', 'span', 'disagree', 'fault'] as const;
const offRow = only(...always);
const onRow = only(...always, 'miss', 'columns', 'pixel');

const rowOf = /"row":(-?\d+)[,}]/;
const xOf = /"x":(-?\d+)[,}]/;

/** Whether a line clearly contains a number that differs from a value. */
function isOther(line: string, field: RegExp, value: number): boolean {
  const found = line.includes('\\') ? null : field.exec(line);
  return found !== null && Number(found[1]) !== value;
}

/** The history of a pixel in the Z-buffer algorithm: the lines on its row, and on these the events at its column. */
export class ZBufferWatch implements Watch {
  known: Known = {};
  private readonly place: Place;

  constructor([x, y]: Pixel) {
    this.place = { x, y, onRow: false, toldAt: 0 };
  }

  get wanted(): Wanted {
    return this.place.onRow ? onRow : offRow;
  }

  /** Most lines are on other rows, and most pixels in the row are other ones. */
  isElsewhere(line: string): boolean {
    const { x, y, onRow } = this.place;
    return onRow ? isOther(line, xOf, x) : isOther(line, rowOf, y);
  }

  see(event: Event, step: number): Outcome | null {
    const judge = judges[event.e] as Judge<EventName> | undefined;
    const outcome = judge?.(event, this.place, step) ?? null;
    if (outcome !== null) this.place.toldAt = step;
    this.follow(event, outcome !== null);
    return outcome;
  }

  private follow(event: Event, told: boolean): void {
    if (event.e === 'polygon') {
      this.known = { zbuffer: { polygon: event.polygon } };
    } else if (event.e === 'line') this.place.onRow = told;
    else if (event.e === 'span') this.place.onRow = false;
  }
}
