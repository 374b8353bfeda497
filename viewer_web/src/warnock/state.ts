import { Effects, noneOfCommon, nothing } from '../replay/effects.js';
import type { Screen } from '../replay/screen.js';
import { corners as cornerNames } from '../trace/events.js';
import type { Event, WarnockEvents } from '../trace/events.js';
import { Refusal } from '../trace/refusal.js';
import type { Box, Color, Corner, N, Vertex } from '../trace/values.js';
import { counted, isRoot, joinedBy, pushedApl, rejoined, wayTo } from './lists.js';

declare module '../replay/model.js' {
  interface Held {
    readonly warnock?: Warnock;
  }
}

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

export interface Clip {
  readonly vertices: readonly Vertex[];
  readonly next: readonly Vertex[];
}

/** Polygons that surround a window or are outside it, each with the level of the window at which it joined the list. */
export type Joined = readonly { readonly polygon: string; readonly level: number }[];

/** The findings about a window. */
interface Found {
  readonly corners: Readonly<Record<Corner, N>> | null;
  readonly k: number | null;
  readonly count: number | null;
  readonly hasSurround: boolean | null;
  readonly color: Color | null;
  readonly insider: boolean | null;
}

/** The state of the current window; null until the trace has begun one. */
export interface Warnock extends Found {
  /** The first window, which contains all others. */
  readonly root: Box | null;
  /** The windows that were divided on the way to the current one, in order; their number is its level. */
  readonly way: readonly Box[];
  readonly stack: readonly StackedWindow[];
  readonly window: Box | null;
  /**
   * The list of active polygons. With three lists, the third one, which all windows share; the other two are in `joined`.
   */
  readonly apl: Apl | null;
  readonly joined: Readonly<Record<'surrounding' | 'outside', Joined>>;
  /** The edge counts of the traversed outline so far, for containment. */
  readonly contained: readonly (Event<'ray'> | Event<'octants'>)[];
  /** The polygon that surrounds the window and hides all others so far; a coarse trace does not have it. */
  readonly covering: string | null;
  readonly clip: Clip | null;
  /** The depths of the current polygon at the corners so far, in the order of their names. */
  readonly depths: readonly N[];
  /** The finding of PointColor so far. */
  readonly nearest: { readonly polygon: string; readonly z: N } | null;
  /** The last findings, possibly about an earlier window: the program's variables keep them until they are set again. */
  readonly last: Found;
}

const nothingFound: Found = {
  corners: null,
  k: null,
  count: null,
  hasSurround: null,
  color: null,
  insider: null,
};

export const emptyWarnock: Warnock = {
  root: null,
  way: [],
  stack: [],
  window: null,
  apl: null,
  joined: { surrounding: [], outside: [] },
  contained: [],
  ...nothingFound,
  covering: null,
  clip: null,
  depths: [],
  nearest: null,
  last: { ...nothingFound, count: 0, hasSurround: false, insider: false },
};

function sameWindow(a: Box, b: Box): boolean {
  return a.every((value, i) => value === b[i]);
}

/** Records findings about the current window. */
const finding = (news: Partial<Found>, { last }: Warnock): Partial<Warnock> => ({
  ...news,
  last: { ...last, ...news },
});

function currentClip(now: Warnock): Clip {
  if (now.clip === null) throw new Refusal('', 'noClip');
  return now.clip;
}

/** Findings outlive their window. */
const kept = ['last'] as const;
const ofWindow = ['corners', 'k', 'count', 'hasSurround', 'color', 'insider'] as const;

/** Windows on the stack may share a list of active polygons. */
const list = { changes: ['apl', 'stack'], needs: ['apl'] } as const;
const joining = { changes: ['apl', 'stack', 'joined'], needs: ['apl', 'joined'] } as const;
const vertex = { changes: ['clip'], needs: ['clip'] } as const;
const painting = { changes: ['picture'], needs: [] } as const;

const keeping = {
  ...vertex,
  does: (event: { readonly vertex: Vertex }, now: Warnock): Partial<Warnock> => {
    const clip = currentClip(now);
    return { clip: { ...clip, next: [...clip.next, event.vertex] } };
  },
};

export const effects = new Effects<keyof WarnockEvents, Warnock, Screen>({
  ...noneOfCommon,
  depth: {
    changes: ['depths'],
    does: ({ at, z }, { depths }) =>
      at === 'PW5' || at === 'HP3'
        ? { depths: [...(depths.length < 4 ? depths : []), z] }
        : undefined,
  },

  push: {
    changes: ['stack', 'root', 'division'],
    reads: ['apl'],
    needs: ['apl'],
    does: (event, now, screen) => {
      event.apl?.forEach(([id]) => screen.polygon(id));
      const { window } = event;
      const stack = [...now.stack, { window, apl: pushedApl(event, now) }];
      const root = isRoot(event) ? window : (now.root ?? window);
      screen.divide(window, root);
      return { stack, root };
    },
  },
  skip: nothing,
  pop: {
    changes: ['stack', 'way'],
    sets: ['window', 'apl', 'nearest', 'covering', ...ofWindow],
    reads: ['window'],
    needs: ['stack'],
    does: ({ window }, now) => {
      const { stack } = now;
      const top = stack.at(-1);
      if (top === undefined) throw new Refusal('', 'emptyStack');
      if (!sameWindow(top.window, window)) throw new Refusal('window', 'notTop');
      const found = { ...nothingFound, nearest: null, covering: null };
      return { stack: stack.slice(0, -1), way: wayTo(window, now), window, apl: top.apl, ...found };
    },
  },
  corners: {
    sets: [...ofWindow, 'covering', 'depths', ...kept],
    does: ({ z }, now) => ({
      ...finding(
        {
          corners: { lb: z, lt: z, rb: z, rt: z },
          k: null,
          count: 0,
          hasSurround: false,
          color: null,
          insider: false,
        },
        now,
      ),
      covering: null,
      depths: [],
    }),
  },
  box: nothing,
  // The current list handles removed and marked polygons.
  discard: list,
  count: {
    sets: ['count', 'depths'],
    changes: kept,
    does: ({ count }, now) => ({ ...finding({ count }, now), depths: [] }),
  },
  compare: nothing,
  nearer: {
    changes: ['corners', ...kept],
    sets: ['k'],
    reads: ['depths'],
    needs: ['corners', 'depths'],
    does: ({ corners, k }, now) => {
      const depths: Partial<Record<Corner, N>> = {};
      for (const corner of corners) {
        const z = now.depths[cornerNames.indexOf(corner)];
        if (z === undefined) throw new Refusal('corners', 'noDepths');
        depths[corner] = z;
      }
      if (now.corners === null) throw new Refusal('', 'noWindow');
      return finding({ k, corners: { ...now.corners, ...depths } }, now);
    },
  },
  uncover: {
    sets: ['hasSurround', 'covering'],
    changes: kept,
    does: (_event, now) => ({ ...finding({ hasSurround: false }, now), covering: null }),
  },
  surround: nothing,
  mark: list,
  cover: {
    sets: ['hasSurround', 'covering', 'color'],
    changes: kept,
    does: ({ polygon, color }, now) => ({
      ...finding({ hasSurround: true, color }, now),
      covering: polygon,
    }),
  },
  insider: {
    sets: ['insider'],
    changes: kept,
    does: ({ inside }, now) => finding({ insider: inside }, now),
  },
  summary: {
    sets: ['count', 'hasSurround', 'color', 'insider'],
    changes: kept,
    does: ({ count, hasSurround, color = null, insider }, now) =>
      finding({ count, hasSurround, color, insider }, now),
  },
  decide: nothing,
  fill: {
    ...painting,
    does: ({ rect, color }, _now, screen) => {
      screen.paint(rect[0], rect[1], rect[2], rect[3], color);
      return undefined;
    },
  },
  nearest: { sets: ['nearest'], does: ({ polygon, z }) => ({ nearest: { polygon, z } }) },
  color: { sets: ['color'], changes: kept, does: ({ color }, now) => finding({ color }, now) },
  orient: nothing,
  clip_begin: {
    sets: ['clip'],
    does: ({ polygon }, _now, screen) => ({
      clip: { vertices: screen.polygon(polygon).vertices, next: [] },
    }),
  },
  clip_side: { ...vertex, does: (_event, now) => ({ clip: { ...currentClip(now), next: [] } }) },
  clip_sign: nothing,
  clip_cross: keeping,
  clip_keep: keeping,
  clip_drop: nothing,
  clip_list: {
    ...vertex,
    does: ({ count }, now) => {
      const { next } = currentClip(now);
      if (next.length !== count) {
        throw new Refusal('count', 'clipCount', String(count), String(next.length));
      }
      return { clip: { vertices: next, next: [] } };
    },
  },
  clip_result: { sets: ['clip'], does: () => ({ clip: null }) },
  row: nothing,
  draw: {
    ...painting,
    does: ({ runs, color }, _now, screen) => {
      for (const [row, first, end] of runs) screen.paint(first, row, end - first, 1, color);
      return undefined;
    },
  },

  back_face: nothing,
  rejoin: { ...joining, does: rejoined },
  join: { ...joining, does: joinedBy },
  relation: { sets: ['contained'], does: () => ({ contained: [] }) },
  trial: nothing,
  meets: { sets: ['contained'], does: () => ({ contained: [] }) },
  ray: { changes: ['contained'], does: counted },
  crossings: nothing,
  octants: { changes: ['contained'], does: counted },
  angle: nothing,
  hiding: {
    sets: ['hasSurround', 'covering'],
    changes: kept,
    does: ({ polygon }, now) => ({
      ...finding({ hasSurround: polygon !== undefined }, now),
      covering: polygon ?? null,
    }),
  },
  split_vertex: nothing,
  edge_depth: nothing,
});
