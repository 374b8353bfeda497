import { polygonThing } from '../algorithm/pointed.js';
import { path, point as dot } from '../picture/mark.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import type { Asker } from '../predict/asker.js';
import { crossing } from '../predict/question.js';
import type { Given, Option } from '../predict/question.js';

/** Which vertices remain after clipping by this side of the window? */
export const clip: Asker<'clip'> = {
  from: 'polygons',
  at: ['clip_side'],
  ask(trace, step) {
    const side = eventAt(trace, step, 'clip_side');
    const list = nextOf(trace, step, 'clip_list', 'clip_result');
    const result = nextOf(trace, step, 'clip_result', 'pop');
    const { clip: begun = null } = trace.timeline.seek(step).values.warnock ?? {};
    if (side === null || list === null || result === null || begun === null) return null;
    const until = list.step;
    const crossed = stepsOf(trace, step, until, 'clip_cross');
    const kept = stepsOf(trace, step, until, 'clip_keep');
    const dropped = stepsOf(trace, step, until, 'clip_drop');
    if (crossed.length + dropped.length === 0) return null;

    // Each vertex in order is kept or dropped, after a crossing of the edge that leads to it.
    const inTurn = inOrder(kept, dropped);
    const entries = inOrder(crossed, kept);
    const right = entries.map((at) =>
      inTurn.includes(at) ? String(inTurn.indexOf(at) + 1) : crossing,
    );
    const vertices = begun.vertices.map((vertex, i): Given => ({
      value: String(i + 1),
      of: 'vertex',
      note: ({ numbers }) => numbers.point(vertex.slice(0, 2)),
      places: [dot('pointed', vertex)],
    }));
    const { length } = vertices;
    const edges = begun.vertices.map((to, i): Option => {
      const before = (i + length - 1) % length;
      const from = begun.vertices[before] ?? to;
      return { value: `${before + 1}–${i + 1}`, places: [path('pointed', [from, to])] };
    });
    const edgeTo = (step: number): string =>
      edges[inTurn.findIndex((at) => at > step)]?.value ?? '';
    const anyEdge: Option = { value: crossing, places: edges.flatMap(({ places = [] }) => places) };
    const { polygon } = result.event;
    return {
      kind: 'clip',
      step,
      until,
      about: { polygon, side: side.side },
      parts: [
        {
          asks: 'cut',
          options: edges,
          right: crossed.map(({ step: at }) => edgeTo(at)),
          given: vertices,
          decidedBy: (edge) => crossed.find(({ step: at }) => edgeTo(at) === edge)?.step,
        },
        {
          asks: 'list',
          options: [...vertices, anyEdge],
          right,
          decidedBy: (_, at) => entries[at],
        },
      ],
      because: inOrder(crossed, kept, dropped, [list]),
      things: [polygonThing(polygon)],
    };
  },
};
