import { covers, test } from '../history/entry.js';
import type { Outcome, Watch } from '../history/entry.js';
import type { Known } from '../language/words.js';
import type { Pixel } from '../picture/pixel.js';
import { only } from '../replay/wanted.js';
import type { Wanted } from '../replay/wanted.js';
import type { Detail, Event, EventName } from '../trace/events.js';
import type { Box } from '../trace/values.js';
import { Lists } from './history-lists.js';
import { wayTo } from './state.js';

interface Place {
  readonly pixel: Pixel;
  readonly detail: Detail;
  /** The current row of FillPolygon, if there is one. */
  row: number | null;
  /** Whether the point of SurroundTest is that of PointColor. */
  centre: boolean;
}

type Judge<K extends EventName> = (event: Event<K>, place: Place) => Outcome | null;

const pass = (): Outcome => 'pass';
const note = (): Outcome => 'note';

function overlaps([x, y, width, height]: Box, [i, j]: Pixel): boolean {
  return x < i + 1 && x + width > i && y < j + 1 && y + height > j;
}

/** The outcome of an event for the pixels of the current window. Other events are steps on the way to these. */
const inWindow: { readonly [K in EventName]?: Judge<K> } = {
  pop: note,
  box: ({ outside }) => test(!outside),
  discard: () => 'fail',
  count: pass,
  // At the level of signs the following comparison includes the depth.
  depth: (_event, { detail }) => (detail === 'signs' ? null : 'note'),
  compare: ({ nearer }) => test(nearer),
  nearer: ({ k }) => test(k > 0),
  uncover: note,
  orient: (_event, { centre }) => (centre ? 'note' : null),
  surround: ({ inside }) => test(inside),
  mark: pass,
  cover: pass,
  insider: ({ inside }) => test(inside),
  summary: note,
  decide: note,
  nearest: pass,
  color: note,
  back_face: ({ away }) => test(!away),
  rejoin: note,
  join: note,
  relation: ({ relation }) => test(relation !== 'outside'),
  meets: note,
  crossings: note,
  angle: note,
  hiding: ({ polygon }) => test(polygon !== undefined),
  split_vertex: ({ splits }) => (splits ? 'note' : null),
  edge_depth: note,
  clip_result: ({ vertices }) => test(vertices.length > 0),
  row: ({ row, first, end }, { pixel: [x, y] }) =>
    row === y ? test(covers([[first, end]], x)) : null,
  draw: () => 'fail',
  disagree: (_event, { row, pixel }) => (row === null || row === pixel[1] ? 'wrong' : null),
};

/** The outcome of an event for the pixel in any window. If it is null, the table above decides. */
const anywhere: { readonly [K in EventName]?: Judge<K> } = {
  push: ({ window }, { pixel }) => (overlaps(window, pixel) ? 'note' : null),
  fill: ({ rect }, { pixel }) => (overlaps(rect, pixel) ? 'paint' : null),
  draw: ({ runs }, { pixel: [x, y] }) =>
    runs.some(([row, ...run]) => row === y && covers([run], x)) ? 'paint' : null,
  fault: (event, { pixel: [x, y] }) => (event.x === x && event.y === y ? 'wrong' : null),
};

/** The relevant events in a window that does not contain the pixel. */
const ways = ['push', 'pop', 'fill', 'draw', 'fault', 'join', 'rejoin'] as const;
const outside = only(...ways);
const outsideSharing = only(...ways, 'discard');

/** The relevant events in a window that contains it. Orientations count only at the pixel's centre. */
function inside(detail: Detail, centre: boolean): Wanted {
  const followed: readonly EventName[] = ['call', 'row', 'disagree', 'join', 'rejoin'];
  const judged = Object.keys({ ...inWindow, ...anywhere }) as EventName[];
  const idle = [...(detail === 'signs' ? ['depth'] : []), ...(centre ? [] : ['orient'])];
  return only(...[...followed, ...judged].filter((name) => !idle.includes(name)));
}

/** The history of a pixel in Warnock's algorithm: the windows that contain it, and the findings about them. */
export class WarnockWatch implements Watch {
  known: Known = {};
  private readonly lists = new Lists();
  private readonly place: Place;
  private readonly atCentre: Wanted;
  private readonly elsewhere: Wanted;
  private inside = false;
  private seen = 0;
  private covering: string | null = null;
  private window: Box | null = null;
  private way: readonly Box[] = [];

  constructor(pixel: Pixel, detail: Detail) {
    this.place = { pixel, detail, row: null, centre: false };
    this.atCentre = inside(detail, true);
    this.elsewhere = inside(detail, false);
  }

  get wanted(): Wanted {
    if (this.inside) return this.place.centre ? this.atCentre : this.elsewhere;
    return this.lists.shared ? outsideSharing : outside;
  }

  see(event: Event, step: number): Outcome | null {
    if (step > this.seen + 1) this.place.row = null;
    this.seen = step;
    this.follow(event);
    const judge = anywhere[event.e] as Judge<EventName> | undefined;
    return judge?.(event, this.place) ?? (this.inside ? this.found(event) : null);
  }

  private found(event: Event): Outcome | null {
    const judge = inWindow[event.e] as Judge<EventName> | undefined;
    return judge?.(event, this.place) ?? null;
  }

  /** Updates the data that later events refer to. */
  private follow(event: Event): void {
    if (event.e !== 'disagree') this.place.row = event.e === 'row' ? event.row : null;
    if (event.e === 'push') this.lists.push(event);
    else if (event.e === 'discard') this.lists.discard(event.polygon);
    else if (event.e === 'join') this.lists.join(event);
    else if (event.e === 'rejoin') this.lists.rejoin(event);
    else if (event.e === 'pop') this.enter(event.window);
    else if (event.e === 'decide' || event.e === 'summary') this.knowLists();
    else if (event.e === 'nearest') this.know({ nearest: event });
    else if (event.e === 'cover') this.covering = event.polygon;
    else if (event.e === 'hiding') this.covering = event.polygon ?? null;
    else if (event.e === 'call') this.place.centre = event.at === 'PC2';
    else if (event.e === 'uncover') {
      this.know({ covering: this.covering });
      this.covering = null;
    }
  }

  private enter(window: Box): void {
    this.lists.pop();
    this.way = wayTo(window, { way: this.way, window: this.window });
    this.window = window;
    this.inside = overlaps(window, this.place.pixel);
    this.covering = null;
    if (this.inside) this.know({ window, way: this.way, nearest: null, ...this.lists.known });
  }

  private knowLists(): void {
    this.know({ ...this.lists.known, covering: this.covering });
  }

  private know(news: Partial<NonNullable<Known['warnock']>>): void {
    if (!this.inside) return;
    const old = this.known.warnock ?? { window: null, apl: null, covering: null, nearest: null };
    this.known = { warnock: { ...old, ...news } };
  }
}
