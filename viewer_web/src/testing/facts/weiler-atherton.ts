import type { WeilerAthertonEvents } from '../../trace/events.js';
import type { N } from '../../trace/values.js';
import { answered, listed, none, of, only, said, total } from './fact.js';
import type { Facts, Says } from './fact.js';
import { orderOfNumbers, value } from './shown.js';

type Loops = readonly (readonly (readonly N[])[])[];

const vertices = (region: Loops): number => region.flat().length;

/** The number of its vertices, and of its loops if there are several. */
const size = (region: Loops): readonly number[] => [
  vertices(region),
  ...(region.length > 1 ? [region.length] : []),
];

/** The corners of the bounding box, if it is finite. */
function bounds(region: Loops): readonly number[] {
  const [xs, ys] = [0, 1].map((axis) => region.flat().map((at) => value(at[axis] ?? 'nan')));
  if (![xs, ys].flat().every(Number.isFinite)) return [];
  return [xs, ys].flatMap((values = []) => [Math.min(...values), Math.max(...values)]);
}

export const weilerAthertonFacts: Facts<Exclude<keyof WeilerAthertonEvents, 'row'>> = {
  cut_to_area: ({ polygon, region }) =>
    of(polygon, ...(region.length === 0 ? [] : [vertices(region)])),
  pierce: ({ polygon, other, normal, point }) => ({
    ids: [polygon, other],
    numbers: [...normal, ...point],
  }),
  split: ({ polygon }) => of(polygon),
  facets: ({ pieces }) => only(pieces.length),
  greatest_depth: ({ polygon, z }) => of(polygon, z),
  sorted: ({ polygons }) => ({ ids: listed(polygons), numbers: more(polygons) }),
  push_list: ({ at, pieces }) => {
    const ids = pieces.map(([id]) => id);
    return {
      ids: at === 'WA9' ? [...listed(ids), ...ids.slice(-1)] : listed(ids),
      numbers: [...(at === 'WA6' ? [ids.length] : []), ...more(ids)],
    };
  },
  pop_list: ({ clip, count }) => of(clip, count),
  beside: ({ polygon }, { after, looked }) => {
    const { pieces = [] } = after.weilerAtherton?.list ?? {};
    const [piece, clip] = [pieces[looked], pieces[0]];
    return {
      ids: [polygon, clip?.[0] ?? ''],
      numbers: [...bounds(piece?.[1] ?? []), ...bounds(clip?.[1] ?? [])],
    };
  },
  clipped: ({ at, polygon, clip, inside, outside }) => {
    const ids = [polygon, clip];
    if (inside.length === 0) return { ids, says: [said(/^No part/u, /нет ничего/u)] };
    if (at === 'SP1') return { ids, numbers: size(inside) };
    if (outside.length === 0) return { ids, says: [said(/^All of/u, /^Вся/u)] };
    return { ids, numbers: [...size(inside), ...size(outside)] };
  },
  edge_piece: ({ from, to, lies }) => ({
    numbers: [...from, ...to],
    says: [
      {
        inside: said(/lies inside/u, /внутри отсекающей/u),
        outside: said(/lies outside/u, /снаружи отсекающей/u),
        same_side: said(/counts as inside/u, /считается внутренним/u),
        other_side: said(/counts as outside/u, /считается внешним/u),
      }[lies],
    ],
  }),
  entering: ({ point }) => only(...point),
  leaving: ({ point }) => only(...point),
  behind: ({ polygon, clip, point, z, clipZ, order, behind }) => ({
    ids: [polygon, clip],
    numbers: [...point, z, clipZ],
    says: [
      ...answered(behind, said(/is behind/u, /сзади/u), said(/is nearer/u, /ближе/u)),
      {
        '-1': said(/ less, so/u, / меньше, поэтому/u),
        0: said(/ equal, and/u, / глубины равны, и/u),
        1: said(/ greater, so/u, / больше, поэтому/u),
      }[order],
      ...countsIfOther(order, z, clipZ),
    ],
  }),
  nearer_ones: ({ polygons }, { after }) => ({
    ids: [...listed(polygons), after.weilerAtherton?.list?.pieces[0]?.[0] ?? ''],
    numbers: more(polygons),
  }),
  show: ({ polygon, region }) => of(polygon, ...size(region)),
  order: ({ polygon, other, point, z, otherZ, order }) => ({
    ids: [polygon, other],
    numbers: [...point, z, otherZ],
    says: [
      {
        '-1': said(/ behind/u, /дальше, чем/u),
        0: said(/as near as/u, /так же близко/u),
        1: said(/nearer than/u, /ближе, чем/u),
      }[order],
      ...countsIfOther(order, z, otherZ),
    ],
  }),
  paint: ({ polygon, runs }) => of(polygon, ...(total(runs) === 0 ? [] : [total(runs)])),
  painted: () => none,
};

/** If the depths as written have another order, the sentence says that they count as having this one. */
const countsIfOther = (order: number, z: N, other: N): readonly Says[] =>
  orderOfNumbers(z, other) === order ? [] : [said(/counts as /u, /считается/u)];

/** The length of a list, if it is long. */
const more = (ids: readonly string[]): readonly number[] => (ids.length > 6 ? [ids.length] : []);
