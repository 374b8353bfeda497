import { edgeThing, polygonThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { cellsOf, edgeNote } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';

/** How deep is an edge-on polygon at this point? */
export const edgeDepth: Asker<'edgeDepth'> = {
  isOf: (method) => method === 'warnock-edges',
  from: 'polygons',
  at: ['surround'],
  ask(trace, step) {
    if (eventAt(trace, step + 1, 'edge_depth') === null) return null;
    const result = nextOf(trace, step, 'depth', 'call', 'pop');
    const polygon = trace.header.scene.byId.get(result?.event.polygon ?? '');
    const right = result === null ? null : cellsOf([result.event.z]);
    if (result === null || polygon === undefined || right === null) return null;
    const edges = stepsOf(trace, step, result.step, 'edge_depth');
    return {
      kind: 'edgeDepth',
      step,
      until: result.step,
      about: { polygon: polygon.id, point: result.event.point },
      parts: [
        {
          asks: 'spanning',
          options: polygon.vertices.map((_, edge) => ({
            value: String(edge),
            note: edgeNote(polygon, edge),
          })),
          right: edges.map(({ event }) => String(event.edge)),
          decidedBy: (edge) => edges.find(({ event }) => String(event.edge) === edge)?.step,
        },
        { asks: 'z', options: [], right },
      ],
      because: inOrder(edges, [result]),
      things: [polygonThing(polygon.id), ...edges.map(({ event }) => edgeThing(event.edge))],
    };
  },
};
