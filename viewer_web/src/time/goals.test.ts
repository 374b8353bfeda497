import { describe, expect, it } from 'vitest';
import { historyIn } from '../testing/histories.js';
import { headerOf, textOf, textWith, traceOf } from '../testing/traces.js';
import { Goals, around } from './goals.js';

const goalsIn = async (name: string): Promise<Goals> =>
  new Goals(await traceOf(textOf(`${name}.jsonl`)));

describe('the goals of a run include', () => {
  it('splits of windows', async () => {
    const goals = await goalsIn('small.warnock.windows');
    expect(goals.stepsOf('split', null)).toEqual([3, 9, 15, 27, 39, 45, 63, 81, 99]);
  });

  it('changes of the AEL', async () => {
    const goals = await goalsIn('small.zbuffer.signs');
    expect(goals.stepsOf('ael', null)).toEqual([15, 16, 73, 74, 82, 85]);
  });

  it('steps of a polygon, in the Z-buffer even those that do not name it', async () => {
    const warnock = await goalsIn('inside.warnock.signs');
    expect(warnock.stepsOf({ polygon: 'A' }, null)).toEqual([
      1, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 19, 20, 21, 22, 31,
    ]);
    const zbuffer = await goalsIn('small.zbuffer.windows');
    expect(zbuffer.stepsOf({ polygon: 'A' }, null)).toEqual([2, 3, 4, 5, 6, 7, 8, 9, 10]);
    expect(zbuffer.stepsOf({ polygon: 'B' }, null)).toEqual([11, 12, 13, 14, 15, 16, 17, 18, 19]);
  });

  it('steps of the chosen pixel', async () => {
    const goals = await goalsIn('small.zbuffer.windows');
    const history = await historyIn('small.zbuffer.windows', [4, 0]);
    expect(goals.stepsOf('pixel', history)).toEqual([1, 6, 15]);
    expect(goals.stepsOf('pixel', null)).toEqual([]);
  });

  it('wrong decisions, if the trace was checked', async () => {
    const text = textWith(headerOf('zbuffer'), [
      { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
      { e: 'disagree', at: 'Z2', of: 'rows', taken: [0, 7], exact: [0, 8], cause: 'rounded' },
    ]);
    expect(new Goals(await traceOf(text)).stepsOf('wrong', null)).toEqual([2]);
    expect((await goalsIn('small.zbuffer.signs')).stepsOf('wrong', null)).toEqual([]);
  });
});

describe('the nearest', () => {
  it.each([
    [0, null, 3],
    [3, null, 9],
    [4, 3, 9],
    [9, 3, 15],
    [15, 9, null],
    [20, 15, null],
  ])('of step %i are %o and %o', (step, back, forward) => {
    expect(around([3, 9, 15], step)).toEqual({ back, forward });
  });
});
