import { Effects, noneOfCommon, nothing } from '../replay/effects.js';
import type { Screen } from '../replay/screen.js';
import type { WeilerAthertonEvents } from '../trace/events.js';
import { Refusal } from '../trace/refusal.js';
import type { Point } from '../trace/values.js';
import type { Piece, Region } from './events.js';

declare module '../replay/model.js' {
  interface Held {
    readonly weilerAtherton?: WeilerAtherton;
  }
}

declare module '../language/words.js' {
  interface Known {
    readonly weilerAtherton?: Pick<WeilerAtherton, 'inHand'>;
  }
}

export type List = readonly Piece[];

/** The list that was popped from the stack; its first piece is the clip polygon. */
export interface ListInHand {
  readonly pieces: List;
  /** The number of pieces processed so far, including the clip polygon. */
  readonly seen: number;
  readonly inside: List;
  readonly outside: List;
  /** Whether the clip polygon hides each inside part that is not background, in their order. */
  readonly behind: readonly boolean[];
}

/** The crossings found so far at which the outline of the clipped region enters or leaves the clip region. */
export interface Crossings {
  readonly entering: readonly Point[];
  readonly leaving: readonly Point[];
}

/** The state of Weiler and Atherton's algorithm. */
export interface WeilerAtherton {
  /** The stack, from bottom to top. */
  readonly lists: readonly List[];
  readonly inHand: ListInHand | null;
  readonly facets: List;
  readonly visible: List;
  readonly crossings: Crossings;
  /** The two polygons that are being split, and the line of the split. */
  readonly piercing: WeilerAthertonEvents['pierce'] | null;
}

const noCrossings: Crossings = { entering: [], leaving: [] };

export const emptyWeilerAtherton: WeilerAtherton = {
  lists: [],
  inHand: null,
  facets: [],
  visible: [],
  crossings: noCrossings,
  piercing: null,
};

/** The canvas to paint on. */
type Canvas = Pick<Screen, 'isGround' | 'paint'>;

const isEmpty = (region: Region): boolean => region.length === 0;

/** The current list. The next piece in it must be of this polygon. */
function handWith(polygon: string, { inHand }: WeilerAtherton): readonly [ListInHand, Piece] {
  if (inHand === null) throw new Refusal('', 'noListInHand');
  const next = inHand.pieces[inHand.seen];
  if (next?.[0] !== polygon) throw new Refusal('polygon', 'notNextPiece', polygon);
  return [inHand, next];
}

/** Records that a piece of the current list is inside, outside, or divided between both. */
function parted(
  polygon: string,
  now: WeilerAtherton,
  inside: Region,
  outside: (whole: Region) => Region,
): Partial<WeilerAtherton> {
  const [hand, [, whole, ground]] = handWith(polygon, now);
  const added = (list: List, part: Region): List =>
    isEmpty(part) ? list : [...list, [polygon, part, ground]];
  return {
    inHand: {
      ...hand,
      seen: hand.seen + 1,
      inside: added(hand.inside, inside),
      outside: added(hand.outside, outside(whole)),
    },
  };
}

export const effects = new Effects<keyof WeilerAthertonEvents, WeilerAtherton, Canvas>({
  ...noneOfCommon,
  cut_to_area: {
    changes: ['facets'],
    sets: ['crossings'],
    does: ({ polygon, region }, { facets }) => ({
      crossings: noCrossings,
      facets: isEmpty(region) ? facets : [...facets, [polygon, region, false]],
    }),
  },
  pierce: { sets: ['piercing'], does: (event) => ({ piercing: event }) },
  split: nothing,
  facets: {
    sets: ['facets', 'piercing'],
    does: ({ pieces }) => ({ facets: pieces, piercing: null }),
  },
  greatest_depth: nothing,
  sorted: nothing,
  push_list: {
    changes: ['lists'],
    does: ({ pieces }, { lists }) => ({ lists: [...lists, pieces] }),
  },
  pop_list: {
    changes: ['lists'],
    sets: ['inHand'],
    needs: ['lists'],
    does: ({ clip, count }, { lists }) => {
      const pieces = lists.at(-1);
      if (pieces === undefined) throw new Refusal('', 'noList');
      if (pieces[0]?.[0] !== clip || pieces.length !== count) {
        throw new Refusal('clip', 'notTopList');
      }
      return {
        lists: lists.slice(0, -1),
        inHand: { pieces, seen: 1, inside: [], outside: [], behind: [] },
      };
    },
  },
  beside: {
    changes: ['inHand'],
    needs: ['inHand'],
    does: ({ polygon }, now) => parted(polygon, now, [], (whole) => whole),
  },
  // SplitPiercing only examines the common part of two polygons.
  clipped: {
    changes: ['inHand'],
    sets: ['piercing', 'crossings'],
    needs: ['inHand'],
    does: ({ at, polygon, inside, outside }, now) => ({
      ...(at === 'WA5' ? parted(polygon, now, inside, () => outside) : {}),
      piercing: null,
      crossings: noCrossings,
    }),
  },
  edge_piece: nothing,
  entering: {
    changes: ['crossings'],
    does: ({ point }, { crossings }) => ({
      crossings: { ...crossings, entering: [...crossings.entering, point] },
    }),
  },
  leaving: {
    changes: ['crossings'],
    does: ({ point }, { crossings }) => ({
      crossings: { ...crossings, leaving: [...crossings.leaving, point] },
    }),
  },
  behind: {
    changes: ['inHand'],
    needs: ['inHand'],
    does: ({ behind }, { inHand }) => {
      if (inHand === null) throw new Refusal('', 'noListInHand');
      return { inHand: { ...inHand, behind: [...inHand.behind, behind] } };
    },
  },
  nearer_ones: {
    changes: ['inHand'],
    needs: ['inHand'],
    does: (_event, { inHand }) => {
      if (inHand === null) throw new Refusal('', 'noListInHand');
      const asked = inHand.inside.filter(([, , ground]) => !ground);
      const { behind } = inHand;
      if (asked.length !== behind.length) {
        throw new Refusal('', 'behindCount', String(behind.length), String(asked.length));
      }
      return {
        inHand: { ...inHand, inside: asked.filter((_, i) => behind[i] !== true), behind: [] },
      };
    },
  },
  show: {
    changes: ['visible'],
    does: ({ polygon, region }, { visible }) => ({
      visible: [...visible, [polygon, region, false]],
    }),
  },
  row: nothing,
  order: nothing,
  paint: {
    changes: ['picture'],
    needs: [],
    does: ({ color, runs }, _now, canvas) => {
      for (const [row, first, end] of runs) canvas.paint(first, row, end - first, 1, color);
      return undefined;
    },
  },
  painted: {
    changes: ['picture'],
    does: (_event, _now, screen) => {
      screen.isGround = true;
      return undefined;
    },
  },
});
