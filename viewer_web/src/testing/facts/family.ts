import type { FamilyEvents } from '../../trace/events.js';
import { answered, of, only, said } from './fact.js';
import type { Facts } from './fact.js';
import { known, outside } from './warnock.js';

export const familyFacts: Facts<keyof FamilyEvents> = {
  back_face: ({ polygon, away }) => ({
    ids: [polygon],
    says: answered(away, said(/looks away/u, /нелицевая/u), said(/looks towards/u, /это лицевая/u)),
  }),
  rejoin: ({ polygon, level }) => of(polygon, level),
  join: ({ polygon, list, level }, moment) => ({
    // The window's level is counted twice: by the program, and here from the pushed windows.
    ...of(polygon, level === moment.level ? level : NaN),
    says: answered(
      list === 'outside',
      said(/the outside polygons/u, /внешних/u),
      said(/the surrounding polygons/u, /охватывающих/u),
    ),
  }),
  relation: ({ polygon, relation }) => ({
    ids: [polygon],
    says: [
      {
        outside,
        inside: said(/lies wholly inside/u, /лежит целиком внутри/u),
        intersecting: said(/intersects the window/u, /пересекает окно/u),
        surrounding: said(/surrounds the window/u, /охватывает окно/u),
      }[relation],
    ],
  }),
  trial: ({ polygon, edge, meets }) => ({
    ...of(polygon, edge),
    says: answered(
      meets,
      said(/ meets the/u, /[^е] пересекает/u),
      said(/does not meet/u, /не пересекает/u),
    ),
  }),
  meets: ({ polygon, meets }) => ({
    ids: [polygon],
    says: answered(
      meets,
      said(/^An edge/u, /^Одно из рёбер/u),
      said(/^No edge/u, /^Ни одно ребро/u),
    ),
  }),
  ray: ({ edge }, { counted }) => only(edge, counted),
  crossings: ({ polygon, count }) => ({
    ...of(polygon, count),
    says: answered(count % 2 === 1, said(/surrounds/u, /охватывает/u), outside),
  }),
  octants: ({ edge, from, to, difference }, { counted }) =>
    only(edge, from, to, difference, counted),
  angle: ({ polygon, octants }) => ({
    ...of(polygon, octants),
    says: answered(octants !== 0, said(/surrounds/u, /охватывает/u), outside),
  }),
  hiding: ({ polygon = null }) => known(polygon),
  split_vertex: ({ polygon, vertex, column, row, splits }) => ({
    ...of(polygon, vertex, column, row),
    says: answered(
      splits,
      said(/is split next to it/u, /делится рядом/u),
      said(/nothing to split/u, /делить нечего/u),
    ),
  }),
  edge_depth: ({ polygon, edge, z }) => of(polygon, edge, z),
};
