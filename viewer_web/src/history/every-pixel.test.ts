import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import type { Pixel } from '../picture/pixel.js';
import { textOf, traceNames, traceOf } from '../testing/traces.js';
import type { Trace } from '../replay/trace.js';
import { viewOf } from '../algorithm/view.js';
import { History } from './history.js';

function pixelsOf({ header }: Trace): readonly Pixel[] {
  const { x, y, width, height } = header.scene.area;
  return Array.from({ length: width * height }, (_, i) => [
    x + (i % width),
    y + Math.floor(i / width),
  ]);
}

describe.each(traceNames)('every pixel of %s', (name) => {
  it('has the sentences of the player', async () => {
    const trace = await traceOf(textOf(name));
    for (const pixel of pixelsOf(trace)) {
      const history = new History(trace, pixel);
      history.read();
      for (const entry of history.entries) {
        const missed = entry.outcome === 'fail' && ['draw', 'span'].includes(entry.event.e);
        if (missed) continue;
        for (const language of languages) {
          const { sentence } = viewOf(trace, entry.step, { language, pixel: null, pointed: null });
          expect(history.sentence(entry, language)).toBe(sentence);
        }
      }
    }
  });

  it('ends with the colour that was painted last', async () => {
    const trace = await traceOf(textOf(name));
    const { picture } = trace.timeline.seek(trace.timeline.length).screen;
    const { area } = trace.header.scene;
    for (const [x, y] of pixelsOf(trace)) {
      const history = new History(trace, [x, y]);
      history.read();
      const { painter } = history;
      const before = trace.timeline.seek((painter?.step ?? 1) - 1).values.step;
      const { screen } = trace.timeline.seek(before + 1);
      const then = screen.picture.row(y - area.y)[x - area.x];
      trace.timeline.seek(trace.timeline.length);
      expect(then).toBe(picture.row(y - area.y)[x - area.x]);
    }
  });
});
