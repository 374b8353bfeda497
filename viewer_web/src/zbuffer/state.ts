import type { Screen } from '../replay/screen.js';
import type { CommonEvents, Event, EventName, ZBufferEvents } from '../trace/events.js';
import { Refusal } from '../trace/refusal.js';
import type { N } from '../trace/values.js';

declare module '../replay/model.js' {
  interface Held {
    readonly zbuffer?: ZBuffer;
  }
}

declare module '../language/words.js' {
  interface Known {
    readonly zbuffer?: Pick<ZBuffer, 'polygon'>;
  }
}

/** An entry of the active edge list. */
export interface ActiveEdge {
  readonly edge: number;
  readonly x: N;
  readonly z: N;
  readonly until: N;
  readonly dx: N;
  readonly dz: N;
}

/** The progress of a polygon's scan. */
interface Scanned {
  readonly y: N | null;
  readonly row: number | null;
  readonly nextS: N | null;
  readonly nextAel: N | null;
}

/** The state of the current polygon; null until the trace has begun one. */
export interface ZBuffer extends Scanned {
  readonly polygon: string | null;
  readonly edges: readonly number[];
  readonly ael: readonly ActiveEdge[];
  /** The last progress, possibly of an earlier polygon: the program's variables keep it until they are set again. */
  readonly last: Scanned;
}

const notScanned: Scanned = { y: null, row: null, nextS: null, nextAel: null };

export const emptyZBuffer: ZBuffer = {
  polygon: null,
  edges: [],
  ael: [],
  ...notScanned,
  last: notScanned,
};

type Name = keyof (CommonEvents & ZBufferEvents);
type Handler<K extends EventName> = (
  event: Event<K>,
  now: ZBuffer,
  screen: Screen,
) => Partial<ZBuffer>;
type Handlers = { readonly [K in Name]: Handler<K> };

const unchanged: Partial<ZBuffer> = {};
const nothing = (): Partial<ZBuffer> => unchanged;

/** Records progress of the current polygon's scan. */
const scanning = (news: Partial<Scanned>, { last }: ZBuffer): Partial<ZBuffer> => ({
  ...news,
  last: { ...last, ...news },
});

function entry(now: ZBuffer, edge: number): ActiveEdge {
  const found = now.ael.find((each) => each.edge === edge);
  if (found === undefined) throw new Refusal('edge', 'notInAel', String(edge));
  return found;
}

/** The list without some elements, each of which must be in it. */
function without(list: readonly number[], gone: readonly number[], reason: 'notInS' | 'notInAel') {
  const missing = gone.find((edge) => !list.includes(edge));
  if (missing !== undefined) throw new Refusal('edges', reason, String(missing));
  return list.filter((edge) => !gone.includes(edge));
}

function paintSpan(
  { row, runs, depths }: ZBufferEvents['span'],
  polygon: string | null,
  screen: Screen,
): void {
  if (polygon === null) throw new Refusal('', 'noPolygon');
  const { color } = screen.polygon(polygon);
  for (const [first, end] of runs) screen.paint(first, row, end - first, 1, color);
  if (depths !== undefined) storeDepths(row, runs, depths, screen);
}

function storeDepths(
  row: number,
  runs: ZBufferEvents['span']['runs'],
  depths: readonly N[],
  { z, scene: { area } }: Screen,
): void {
  const pixels = runs.reduce((sum, [first, end]) => sum + end - first, 0);
  if (pixels !== depths.length) {
    throw new Refusal('depths', 'depthCount', String(depths.length), String(pixels));
  }
  let next = 0;
  for (const [first, end] of z === null ? [] : runs) {
    for (let x = first; x < end; x++) z?.set(x - area.x, row - area.y, depths[next++] ?? 0);
  }
}

const handlers: Handlers = {
  plane: nothing,
  call: nothing,
  depth: nothing,
  fault: nothing,
  disagree: nothing,
  clear: ({ color, z }, _now, screen) => {
    screen.clear(color, z);
    return unchanged;
  },
  polygon: ({ polygon }, _now, screen) => {
    screen.polygon(polygon);
    return { polygon, edges: [], ael: [], ...notScanned };
  },
  edge: ({ edge }, { edges }) => ({ edges: [...edges, edge] }),
  extent: nothing,
  scanline: ({ y, row }, now) => scanning({ y, row }, now),
  ael_add: ({ edge, x, z, until, dx, dz }, { ael }) => {
    if (ael.some((each) => each.edge === edge)) {
      throw new Refusal('edge', 'twiceInAel', String(edge));
    }
    return { ael: [...ael, { edge, x, z, until, dx, dz }] };
  },
  horizontal: nothing,
  leave: ({ edges, next }, now) => ({
    edges: without(now.edges, edges, 'notInS'),
    ...scanning({ nextS: next }, now),
  }),
  ael_sort: ({ edges, next }, now) => {
    if (edges.length !== now.ael.length || new Set(edges).size !== edges.length) {
      throw new Refusal('edges', 'notAnOrder');
    }
    return { ael: edges.map((edge) => entry(now, edge)), ...scanning({ nextAel: next }, now) };
  },
  line: nothing,
  miss: nothing,
  slope: nothing,
  columns: nothing,
  pixel: nothing,
  span: (event, { polygon }, screen) => {
    paintSpan(event, polygon, screen);
    return unchanged;
  },
  ael_drop: ({ edges, next }, now) => {
    without(
      now.ael.map(({ edge }) => edge),
      edges,
      'notInAel',
    );
    const ael = now.ael.filter(({ edge }) => !edges.includes(edge));
    return { ael, ...scanning({ nextAel: next }, now) };
  },
  ael_step: ({ edge, x, z }, now) => {
    const stepped = { ...entry(now, edge), x, z };
    return { ael: now.ael.map((each) => (each.edge === edge ? stepped : each)) };
  },
};

/** The state after an event of this method. */
export function afterZBuffer(event: Event, now: ZBuffer, screen: Screen): ZBuffer {
  const handler = handlers[event.e as Name] as Handler<EventName>;
  const news = handler(event, now, screen);
  return news === unchanged ? now : { ...now, ...news };
}
