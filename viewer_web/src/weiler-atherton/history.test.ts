import { describe, expect, it } from 'vitest';
import { historyOf } from '../history/history.js';
import type { History } from '../history/history.js';
import { sayWhy } from '../history/say.js';
import type { Pixel } from '../picture/pixel.js';
import { textOf, traceOf } from '../testing/traces.js';

async function historyAt(pixel: Pixel): Promise<History> {
  const trace = await traceOf(textOf('wedge.weiler-atherton.polygons.jsonl'));
  const history = historyOf(trace, pixel);
  if (history === null) throw new Error('no such pixel');
  history.read();
  return history;
}

describe('the history of a pixel among regions', () => {
  it('tells what the pieces over its centre go through, until one of them shows', async () => {
    // The centre (5.5, 5.5) lies in A and in B, which is nearer, and not in C.
    const { entries } = await historyAt([5, 5]);
    const told = entries.map(({ event: { e }, outcome }) => `${e} ${outcome}`);
    expect(told).toEqual([
      'cut_to_area note', // A
      'cut_to_area note', // B
      'split note', // A, whose left piece it lies in
      'pop_list note', // C clips: both are beside it
      'beside note',
      'beside note',
      'pop_list note', // B clips
      'clipped pass', // of A the part inside
      'behind fail', // is behind
      'show pass', // B
      'paint paint',
    ]);
  });

  it('says why the pixel has its colour', async () => {
    const history = await historyAt([5, 5]);
    const { painter } = history;
    expect(painter && sayWhy(painter, history, 'en')).toBe(
      'Why it has this colour: its centre lies in a visible region, where B is the nearest.',
    );
  });

  it('is empty where no polygon is', async () => {
    const { entries, painter } = await historyAt([0, 0]);
    expect(entries).toEqual([]);
    expect(painter).toBeNull();
  });
});
