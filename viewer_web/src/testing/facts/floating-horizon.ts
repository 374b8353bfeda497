import { hasDefect } from '../../trace/editions.js';
import type { FloatingHorizonEvents } from '../../trace/events.js';
import { answered, none, only, said } from './fact.js';
import type { Facts } from './fact.js';

export const floatingHorizonFacts: Facts<keyof FloatingHorizonEvents> = {
  horizons: ({ upper, lower }) =>
    upper === undefined || lower === undefined ? none : only(upper, lower),
  curve: ({ curve }) => only(curve),
  side_edge: ({ at, sample }) => ({
    numbers: sample,
    says: answered(at === 'FH3', said(/left/u, /Левое/u), said(/right/u, /Правое/u)),
  }),
  visibility: ({ x, flag }, { height, edition }) => ({
    numbers: [x, flag, ...(height?.x === x ? [height.y] : [])],
    says:
      hasDefect(edition, 'x-h1') && flag === -1
        ? [said(/below it \(−1\)\.$/u, /ниже него \(−1\)\.$/u)]
        : answered(flag === 0, said(/hidden/u, /не видна/u), said(/visible/u, /[^е] видна/u)),
  }),
  intersection: ({ point, columns: [left, right] }) =>
    only(...point, left, ...(left === right ? [] : [right])),
  draw_line: ({ from, to, fromColumns, toColumns }) => {
    const columns = new Set([...fromColumns, toColumns[1]]);
    return columns.size === 1 ? only(...from) : only(...from, ...to);
  },
  horizon: ({ first, last, upper, lower }) => {
    if (last < first) return none;
    const counts = [upper.length, lower.length].filter((n) => n > 0);
    return only(first, ...(first === last ? [] : [last]), ...counts);
  },
  height: ({ x, y, upper, lower }) =>
    upper === undefined || lower === undefined ? only(x, y) : only(x, y, upper, lower),
  raise: ({ x, y }) => only(x, y),
  lower: ({ x, y }) => only(x, y),
  step: ({ x, changes }) => ({
    numbers: [x],
    says: answered(
      changes,
      said(/on the other side/u, /по другую сторону/u),
      said(/still on the same/u, /по ту же/u),
    ),
  }),
};
