import { hasDefect } from '../../trace/editions.js';
import type { ZBufferEvents } from '../../trace/events.js';
import type { N } from '../../trace/values.js';
import { answered, none, of, only, said, total } from './fact.js';
import type { Fact, Facts } from './fact.js';
import { orderOfNumbers, value } from './shown.js';

/** Edges, and the next item if there is one. */
const edgesAnd = ({
  edges,
  next,
}: {
  readonly edges: readonly number[];
  readonly next: N;
}): Fact => (edges.length === 0 ? none : only(...edges, ...(next === 'inf' ? [] : [next])));

export const zBufferFacts: Facts<keyof ZBufferEvents> = {
  clear: ({ z }) => only(z),
  polygon: ({ polygon }) => of(polygon),
  edge: ({ edge, rows }) => {
    const [first, last] = rows ?? [0, -1];
    return last < first ? only(edge) : only(edge, ...new Set([first, last]));
  },
  extent: ({ ymin, ymax }) => only(ymin, ymax),
  scanline: ({ y, row }) => only(row, y),
  ael_add: ({ edge, x, z, until }) => only(edge, x, z, until),
  horizontal: ({ edge }) => only(edge),
  leave: edgesAnd,
  ael_sort: edgesAnd,
  line: ({ row, from, to }) => only(row, ...from, ...to),
  miss: ({ at }) => ({
    says: answered(
      at === 'L1',
      said(/The row lies outside/u, /Строка лежит вне/u),
      said(/No pixel of the area/u, /ни одного пикселя области/u),
    ),
  }),
  slope: ({ dz }) => only(dz),
  columns: ({ first, end, z }) => (first < end ? only(...new Set([first, end - 1]), z) : none),
  pixel: ({ x, y, z, stored, shown }, { edition }) => {
    const order = orderOfNumbers(z, stored);
    const isNearer = order === 1;
    const isBeyond = isNearer && !shown && value(z) > 1;
    const isTie = hasDefect(edition, 'x-z7') && shown && order === 0;
    return {
      ...only(x, y, z, stored, ...(isBeyond ? [1] : [])),
      says: [
        ...answered(
          shown,
          said(/so it shows/u, /многоугольник виден/u),
          said(/stays hidden/u, /многоугольник закрыт/u),
        ),
        isTie
          ? said(/is as near as/u, /так же близко/u)
          : isNearer === shown || isBeyond
            ? said(/ is (not )?nearer than/u, /\d (не )?ближе, чем/u)
            : said(/counts as (not )?nearer than/u, /считается (не )?ближе, чем/u),
      ],
    };
  },
  span: ({ row, runs }, { after }) =>
    total(runs) === 0 ? only(row) : of(after.zbuffer?.polygon ?? '', row, total(runs)),
  ael_drop: edgesAnd,
  ael_step: ({ edge, x, z }) => only(edge, x, z),
};
