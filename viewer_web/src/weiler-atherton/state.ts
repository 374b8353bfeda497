import type { WeilerAtherton } from '../replay/values.js';
import type { Piece } from '../trace/values.js';

export type { WeilerAtherton } from '../replay/values.js';
export type List = readonly Piece[];
/** The list that was popped from the stack; its first piece is the clip polygon. */
export type ListInHand = NonNullable<WeilerAtherton['inHand']>;
export type Crossings = WeilerAtherton['crossings'];

/** Before the first step. */
export const emptyWeilerAtherton: WeilerAtherton = {
  lists: [],
  inHand: null,
  facets: [],
  visible: [],
  crossings: { entering: [], leaving: [] },
  piercing: null,
};
