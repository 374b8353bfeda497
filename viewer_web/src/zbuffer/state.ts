import { Effects, noneOfCommon, nothing } from '../replay/effects.js';
import type { Screen } from '../replay/screen.js';
import type { ZBufferEvents } from '../trace/events.js';
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

/** The values of a scan outlive its polygon. */
const kept = ['last'] as const;

export const effects = new Effects<keyof ZBufferEvents, ZBuffer, Screen>({
  ...noneOfCommon,
  clear: {
    sets: ['picture', 'z'],
    does: ({ color, z }, _now, screen) => {
      screen.clear(color, z);
      return undefined;
    },
  },
  polygon: {
    sets: ['polygon', 'edges', 'ael', 'y', 'row', 'nextS', 'nextAel'],
    does: ({ polygon }, _now, screen) => {
      screen.polygon(polygon);
      return { polygon, edges: [], ael: [], ...notScanned };
    },
  },
  edge: { changes: ['edges'], does: ({ edge }, { edges }) => ({ edges: [...edges, edge] }) },
  extent: nothing,
  scanline: {
    sets: ['y', 'row'],
    changes: kept,
    does: ({ y, row }, now) => scanning({ y, row }, now),
  },
  ael_add: {
    changes: ['ael'],
    needs: ['ael'],
    does: ({ edge, x, z, until, dx, dz }, { ael }) => {
      if (ael.some((each) => each.edge === edge)) {
        throw new Refusal('edge', 'twiceInAel', String(edge));
      }
      return { ael: [...ael, { edge, x, z, until, dx, dz }] };
    },
  },
  horizontal: nothing,
  leave: {
    changes: ['edges', ...kept],
    sets: ['nextS'],
    needs: ['edges'],
    does: ({ edges, next }, now) => ({
      edges: without(now.edges, edges, 'notInS'),
      ...scanning({ nextS: next }, now),
    }),
  },
  ael_sort: {
    changes: ['ael', ...kept],
    sets: ['nextAel'],
    needs: ['ael'],
    does: ({ edges, next }, now) => {
      if (edges.length !== now.ael.length || new Set(edges).size !== edges.length) {
        throw new Refusal('edges', 'notAnOrder');
      }
      return { ael: edges.map((edge) => entry(now, edge)), ...scanning({ nextAel: next }, now) };
    },
  },
  line: nothing,
  miss: nothing,
  slope: nothing,
  columns: nothing,
  pixel: nothing,
  span: {
    changes: ['picture', 'z'],
    reads: ['polygon'],
    needs: ['polygon'],
    does: (event, { polygon }, screen) => {
      paintSpan(event, polygon, screen);
      return undefined;
    },
  },
  ael_drop: {
    changes: ['ael', ...kept],
    sets: ['nextAel'],
    needs: ['ael'],
    does: ({ edges, next }, now) => {
      without(
        now.ael.map(({ edge }) => edge),
        edges,
        'notInAel',
      );
      const ael = now.ael.filter(({ edge }) => !edges.includes(edge));
      return { ael, ...scanning({ nextAel: next }, now) };
    },
  },
  ael_step: {
    changes: ['ael'],
    needs: ['ael'],
    does: ({ edge, x, z }, now) => {
      const stepped = { ...entry(now, edge), x, z };
      return { ael: now.ael.map((each) => (each.edge === edge ? stepped : each)) };
    },
  },
});
