import { polygonThing } from '../algorithm/pointed.js';
import { inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { cellsOf, edgeNote, mostOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { columnsOf } from '../predict/question.js';
import type { Option, Part } from '../predict/question.js';

/** What is the active edge list on the next scanline? */
export const ael: Asker<'ael'> = {
  from: 'polygons',
  at: ['extent', 'span'],
  ask(trace, step) {
    const sort = nextOf(trace, step, 'ael_sort', 'call', 'polygon');
    const { zbuffer } = trace.timeline.seek(step).values;
    const polygon = trace.header.scene.byId.get(zbuffer?.polygon ?? '');
    if (sort === null || zbuffer === undefined || polygon === undefined) return null;
    const { length } = [...zbuffer.edges, ...zbuffer.ael];
    if (length < 2 || zbuffer.edges.length > mostOptions) return null;
    const until = sort.step;
    const added = stepsOf(trace, step, until, 'ael_add');
    const dropped = stepsOf(trace, step, until, 'ael_drop');

    const coming = zbuffer.edges.map((edge) => ({
      value: String(edge),
      note: edgeNote(polygon, edge),
    }));
    const active = zbuffer.ael.map(({ edge, x, dx, until: last }): Option => ({
      value: String(edge),
      note: ({ numbers: { short } }) => `x = ${short(x)}; Δx = ${short(dx)}; y → ${short(last)}`,
    }));
    const leave: Part = {
      asks: 'leave',
      options: active,
      right: dropped.flatMap(({ event }) => event.edges.map(String)),
      decidedBy: (edge) => dropped.find(({ event }) => event.edges.includes(Number(edge)))?.step,
    };
    const stepped = stepsOf(trace, step, until, 'ael_step');
    const then = trace.timeline.seek(until).values.zbuffer?.ael ?? [];
    const cells = cellsOf(then.flatMap(({ x, until: last }) => [x, last]));
    const entries: Part | null = cells && {
      asks: 'entries',
      options: [],
      right: cells,
      decidedBy(_, at) {
        const edge = then[Math.floor(at / columnsOf({ asks: 'entries' }).length)]?.edge;
        return [...added, ...stepped].find(({ event }) => event.edge === edge)?.step;
      },
    };
    return {
      kind: 'ael',
      step,
      until,
      about: { polygon: polygon.id, row: zbuffer.ael.length === 0 ? null : zbuffer.row },
      parts: [
        ...(active.length === 0 ? [] : [leave]),
        {
          asks: 'enter',
          options: coming,
          right: added.map(({ event }) => String(event.edge)),
          decidedBy: (edge) => added.find(({ event }) => String(event.edge) === edge)?.step,
        },
        { asks: 'order', options: [...active, ...coming], right: sort.event.edges.map(String) },
        ...(entries ? [entries] : []),
      ],
      because: inOrder(dropped, stepped, stepsOf(trace, step, until, 'scanline'), added, [sort]),
      things: [polygonThing(polygon.id)],
    };
  },
};
