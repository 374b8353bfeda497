import { describe, expect, it } from 'vitest';
import { historyOf } from '../history/history.js';
import type { History } from '../history/history.js';
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
  it('follows the pieces over its centre, until one of them is visible', async () => {
    // The centre (5.5, 5.5) lies in A and in B, which is nearer, and not in C.
    const { entries } = await historyAt([5, 5]);
    const outcomes = entries.map(({ event: { e }, outcome }) => `${e} ${outcome}`);
    expect(outcomes).toEqual([
      'cut_to_area note', // A
      'cut_to_area note', // B
      'split note', // A: its left piece contains the centre
      'pop_list note', // C clips: A and B are beside it
      'beside note',
      'beside note',
      'pop_list note', // B clips
      'clipped pass', // the inside part of A
      'behind fail', // is behind
      'show pass', // B
      'paint paint',
    ]);
  });

  it('explains the colour of the pixel', async () => {
    const history = await historyAt([5, 5]);
    const { painter } = history;
    expect(painter && history.why(painter, 'en')).toBe(
      'Why it has this colour: its centre lies in a visible region, where B is the nearest.',
    );
  });

  it('is empty where there is no polygon', async () => {
    const { entries, painter } = await historyAt([0, 0]);
    expect(entries).toEqual([]);
    expect(painter).toBeNull();
  });
});
