import { pixelThing, polygonThing } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import { toNumber } from '../language/words.js';
import { box } from '../picture/mark.js';
import { inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import {
  cellsOf,
  comparedNote,
  edgeNote,
  mostOptions,
  relationOf,
  relationOptions,
} from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Fact } from '../predict/facts.js';
import { tolerance } from '../predict/grade.js';
import { columnsOf } from '../predict/question.js';
import type { Option, Part } from '../predict/question.js';

/** Whether there is only one order from left to right. Edges that begin at one place have several right orders. */
const isOrdered = (xs: readonly number[]): boolean =>
  xs.every((x, i) => i === 0 || x - (xs[i - 1] ?? NaN) > tolerance);

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
    const cells = cellsOf(
      then.flatMap(({ x, until: last }) => [x, last]),
      trace.header,
    );
    const isOne = isOrdered(then.map(({ x }) => toNumber(x)));
    // Without an order there is too little to answer about two edges.
    if (!isOne && active.length + coming.length < 3) return null;
    const entries: Part | null = cells && {
      asks: 'entries',
      options: [],
      right: cells,
      decidedBy(_, at) {
        const edge = then[Math.floor(at / columnsOf({ asks: 'entries' }).length)]?.edge;
        return [...added, ...stepped].find(({ event }) => event.edge === edge)?.step;
      },
    };
    const order: Part = {
      asks: 'order',
      options: [...active, ...coming],
      right: sort.event.edges.map(String),
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
        ...(isOne ? [order, ...(entries ? [entries] : [])] : []),
      ],
      because: inOrder(dropped, stepped, stepsOf(trace, step, until, 'scanline'), added, [sort]),
      things: [polygonThing(polygon.id)],
    };
  },
};

/** At which pixels of this row is the polygon nearer than the stored depth? */
export const pixels: Asker<'pixels'> = {
  from: 'signs',
  at: ['columns'],
  ask(trace, step) {
    const span = nextOf(trace, step, 'span', 'call');
    if (span === null) return null;
    const compared = stepsOf(trace, step, span.step, 'pixel').map((at) => {
      const { z, stored, shown } = at.event;
      return { ...at, ...at.event, relation: relationOf(z, stored, shown, trace.header) };
    });
    const contested = compared.filter(
      ({ stored, relation }) => stored !== '-inf' && relation !== null,
    );
    // The pixels around a change from visible to hidden.
    const change = contested.findIndex(
      ({ shown }, i) => shown !== contested[i - 1]?.shown && i > 0,
    );
    const first = Math.max(0, Math.min(change - mostOptions / 2, contested.length - mostOptions));
    const asked = contested.slice(first, first + mostOptions);
    const one = asked.find(({ relation }) => relation === '=') ?? asked[step % asked.length];
    const { polygon = null } = trace.timeline.seek(step).values.zbuffer ?? {};
    if (one?.relation == null || asked.length < 2 || polygon === null) return null;
    return {
      kind: 'pixels',
      step,
      until: span.step,
      about: { polygon, row: one.y },
      parts: [
        {
          asks: 'shown',
          options: asked.map(({ x, z, stored }) => ({
            value: String(x),
            places: [box('pointed', [x, one.y, 1, 1])],
            note: comparedNote(z, stored),
          })),
          right: asked.filter(({ shown }) => shown).map(({ x }) => String(x)),
          decidedBy: (column) => asked.find(({ x }) => String(x) === column)?.step,
        },
        {
          asks: 'pixelDepths',
          options: relationOptions,
          right: [one.relation],
          given: [{ value: String(one.x), of: 'column' }],
        },
      ],
      because: inOrder(asked, [span]),
      things: [pixelThing([one.x, one.y])],
    };
  },
};

/** The current scanline. */
export function facts({ after, language }: View): readonly Fact[] {
  const { y } = after.zbuffer ?? {};
  return y == null ? [] : [['yₜ', texts[language].numbers.short(y)]];
}

export const polygonsAsked = (_view: View, named: string | null): readonly string[] =>
  named === null ? [] : [named];
