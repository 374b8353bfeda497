import { describe, expect, it } from 'vitest';
import { historyIn } from '../testing/histories.js';
import { textOf, traceOf } from '../testing/traces.js';
import { History, historyOf } from './history.js';

describe('a history', () => {
  it('is found by step, and is the same when it is read in parts', async () => {
    const history = await historyIn('small.zbuffer.windows', [2, 0]);
    expect([0, 1, 5, 6, 14, 15, 99].map((step) => history.indexAt(step))).toEqual([
      -1, 0, 0, 1, 1, 2, 2,
    ]);
    const { trace } = await historyIn('small.warnock.signs', [4, 0]);
    const inParts = new History(trace, [4, 0]);
    while (!inParts.read(0));
    const atOnce = new History(trace, [4, 0]);
    atOnce.read();
    expect(inParts.entries).toEqual(atOnce.entries);
  });

  it('exists only for pixels of the picture', async () => {
    const trace = await traceOf(textOf('small.zbuffer.windows.jsonl'));
    expect(historyOf(trace, [2, -1])?.pixel).toEqual([2, -1]);
    for (const pixel of [
      [1, 0],
      [7, 0],
      [2, -2],
      [2, 3],
    ] as const) {
      expect(historyOf(trace, pixel)).toBeNull();
    }
    expect(historyOf(trace, null)).toBeNull();
  });
});
