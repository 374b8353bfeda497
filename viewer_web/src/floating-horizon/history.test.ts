import { describe, expect, it } from 'vitest';
import { History } from '../history/history.js';
import { traceOf } from '../replay/trace.js';
import { readHistory } from '../testing/histories.js';
import { headerOf, textOf, textWith } from '../testing/traces.js';
import type { Edition } from '../trace/editions.js';
import type { Event } from '../trace/events.js';

/** Curve and outcome of each flag over column 4. */
const historyAt = async (detail: string): Promise<readonly unknown[]> => {
  const text = textOf(`hills.floating-horizon.${detail}.jsonl`);
  const { entries } = await readHistory(text, [4, 0]);
  return entries
    .filter(({ event }) => event.e === 'visibility')
    .map(({ under, outcome }) => [under, outcome]);
};

describe('the history of a column', () => {
  // (2, 3), (4, 6): 6 is the first height. (3, 5), (5, 2): 3.5 is above it. (2, 4), (4, 5): 5 lies between 3.5 and 6. (1,
  // 5.5), (6, 3): 5.5 - 2.5 * 3 / 5 = 4 lies between them, too.
  it.each(['polygons', 'signs'])(
    'has the flag of each curve over it, at level %s',
    async (detail) => {
      expect(await historyAt(detail)).toEqual([
        [0, 'pass'],
        [1, 'pass'],
        [2, 'fail'],
        [3, 'fail'],
      ]);
    },
  );

  it('calls a point below visible, except in the printed text, which may not draw it (X-H1)', () => {
    const below: Event = { e: 'visibility', at: 'FH5', segment: [0, 4], x: 4, flag: -1 };
    const outcomeIn = (edition: Edition, ...events: readonly Event[]): unknown => {
      const bytes = textWith({ ...headerOf('floating-horizon'), edition }, [
        { e: 'curve', at: 'FH2', curve: 0 },
        { e: 'call', at: 'FH5', of: 'Visibility' },
        ...events,
      ]);
      const history = new History(traceOf(new TextEncoder().encode(bytes)), [4, 0]);
      history.read();
      return history.entries.at(-1)?.outcome;
    };
    expect(outcomeIn('corrected', below)).toBe('pass');
    expect(outcomeIn('printed', below)).toBe('note');
    expect(outcomeIn('printed', { ...below, flag: 1 })).toBe('pass');
    expect(outcomeIn('printed', { ...below, flag: 0 })).toBe('fail');
  });

  it('has the heights and each change of the horizons if the trace does', async () => {
    const { entries } = await readHistory(textOf('hills.floating-horizon.signs.jsonl'), [4, 0]);
    const said = entries.flatMap(({ event }) =>
      event.e === 'height' || event.e === 'raise' || event.e === 'lower'
        ? [[event.e, event.y]]
        : [],
    );
    expect(said.slice(0, 5)).toEqual([
      ['height', 6],
      ['raise', 6],
      ['lower', 6],
      ['height', 3.5],
      ['raise', 3.5],
    ]);
  });
});
