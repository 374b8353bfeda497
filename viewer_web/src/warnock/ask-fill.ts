import { pixelThing } from '../algorithm/pointed.js';
import { box } from '../picture/mark.js';
import { eventAt, nextOf, stepsOf } from '../predict/ahead.js';
import { mostOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';

/** Which pixels of a row does an outline cover? */
export const fill: Asker<'fill'> = {
  isOf: (method) => method !== 'warnock-simplest',
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'FillPolygon') return null;
    const result = nextOf(trace, step, 'draw', 'pop');
    const { area, byId } = trace.header.scene;
    if (result === null) return null;
    const { polygon } = result.event;
    const outline =
      eventAt(trace, step - 1, 'clip_result')?.vertices ?? byId.get(polygon)?.vertices ?? [];
    const rows = stepsOf(trace, step, result.step, 'row');
    const middle = rows[Math.floor(rows.length / 2)];
    if (middle === undefined || middle.event.exact !== undefined) return null;
    const { row, first, end } = middle.event;
    // The pixels around the left end of the row.
    const from = Math.max(area.x, Math.min(first - 2, area.x + area.width - mostOptions));
    const columns = Array.from(
      { length: Math.min(mostOptions, area.x + area.width - from) },
      (_, i) => from + i,
    );
    if (columns.length < 3) return null;
    return {
      kind: 'fill',
      step,
      until: middle.step,
      about: { polygon, row, outline: outline.map(([x, y]) => [x, y]) },
      parts: [
        {
          asks: 'covered',
          options: columns.map((x) => ({
            value: String(x),
            places: [box('pointed', [x, row, 1, 1])],
          })),
          right: columns.filter((x) => first <= x && x < end).map(String),
        },
      ],
      because: [middle.step],
      things: columns.slice(0, 1).map((x) => pixelThing([x, row])),
    };
  },
};
