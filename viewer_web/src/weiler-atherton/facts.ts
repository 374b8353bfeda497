import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import { mostOptions } from '../predict/asker.js';
import type { Fact } from '../predict/facts.js';
import type { Piece } from '../trace/values.js';
import { ownersOf } from './pieces.js';
import { emptyWeilerAtherton } from './state.js';
import type { WeilerAtherton } from './state.js';

/** The current list, or before the first one the pieces to sort. */
const piecesOf = ({ inHand, facets }: WeilerAtherton): readonly Piece[] => inHand?.pieces ?? facets;

/** The pieces with their outlines in walking order, and the polygons of the other lists from the top of the stack. */
export function facts({ after, texts: page, language }: View): readonly Fact[] {
  const now = after.weilerAtherton;
  if (now === undefined) return [];
  const { regions: say, numbers } = texts[language];
  const pieces = piecesOf(now);
  const listed = pieces.slice(0, mostOptions).map(([id, region, ground]) => {
    const loops = region.map((loop) => loop.map(numbers.point).join(' ')).join(' / ');
    return `${id}${ground ? ` (${say.ground})` : ''}: ${loops}`;
  });
  const others = pieces.length > mostOptions ? [page.more(pieces.length - mostOptions)] : [];
  const lists = [...now.lists].reverse().map((list) => list.map(([id]) => id).join(', '));
  return [
    [now.inHand === null ? say.pieces : say.list, [...listed, ...others].join('; ')],
    [say.lists, lists.join('; ') || '∅'],
  ];
}

export const polygonsAsked = ({ after }: View): readonly string[] =>
  ownersOf(piecesOf(after.weilerAtherton ?? emptyWeilerAtherton));
