import { expect, it } from 'vitest';
import { viewOf } from '../algorithm/view.js';
import { textOf, traceOf } from '../testing/traces.js';
import { marksOf } from './marks.js';
import type { Mark } from './mark.js';

it('what a run computed and is not so is red: the pixel that shows it, or the place', async () => {
  // The centre of pixel (0, 0), (0.5, 0.5), lies in A: there the edge from (0.75, 0) to (0, 2) is at x = 0.5625. A run
  // with one list for all windows has lost A there, and takes the background.
  const trace = await traceOf(textOf('one-list.warnock.signs.jsonl'));
  const sight = { shown: [0, 0, 2, 2], least: 1 } as const;
  const red = new Map<string, readonly Mark[]>();
  for (let step = 1; step <= trace.timeline.length; step++) {
    const view = viewOf(trace, step, { language: 'en', pixel: null, pointed: null });
    const marks = marksOf(view, sight).filter((mark) => 'role' in mark && mark.role === 'wrong');
    if (marks.length > 0) red.set(view.event?.e ?? '', marks);
  }
  expect([...red]).toEqual([
    ['color', [{ kind: 'point', role: 'wrong', at: [0.5, 0.5] }]],
    ['fill', [{ kind: 'box', role: 'wrong', box: [0, 0, 1, 1] }]],
  ]);
});
