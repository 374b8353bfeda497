import { describe, expect, it } from 'vitest';
import { historyIn, last, readHistory, say, steps } from '../testing/histories.js';
import { headerOf, textWith } from '../testing/traces.js';
import type { Event } from '../trace/events.js';

describe('in the Z-buffer', () => {
  it('a pixel that both polygons cover has their lines in its row', async () => {
    const history = await historyIn('small.zbuffer.signs', [4, 0]);
    expect(steps(history)).toEqual([
      [3, 'paint'],
      [32, 'note'],
      [33, 'pass'],
      [36, 'pass'],
      [39, 'paint'],
      [89, 'note'],
      [90, 'pass'],
      [92, 'pass'],
      [94, 'paint'],
    ]);
    expect(history.entries.map(({ under }) => under ?? '')).toEqual([
      '',
      'A',
      'A',
      'A',
      'A',
      'B',
      'B',
      'B',
      'B',
    ]);
    expect(history.why(last(history.entries), 'en')).toBe(
      'Why it has this colour: B is nearer here than everything drawn before, and nothing drawn later replaced it.',
    );
  });

  it('a polygon that is beside the pixel misses it', async () => {
    const history = await historyIn('small.zbuffer.signs', [2, 0]);
    expect(steps(history)).toEqual([
      [3, 'paint'],
      [32, 'note'],
      [33, 'pass'],
      [34, 'pass'],
      [39, 'paint'],
      [89, 'note'],
      [90, 'fail'],
      [94, 'fail'],
    ]);
    expect(history.painter?.step).toBe(39);
    expect(say(last(history.entries), history)).toBe('On this row B leaves the pixel as it is.');
  });

  it('has fewer entries with less detail', async () => {
    const polygons = await historyIn('small.zbuffer.polygons', [2, 0]);
    expect(polygons.entries.map(({ event }) => event.e)).toEqual([
      'clear',
      'line',
      'span',
      'line',
      'span',
    ]);
    expect(steps(await historyIn('small.zbuffer.windows', [2, 0]))).toEqual([
      [1, 'paint'],
      [6, 'paint'],
      [15, 'fail'],
    ]);
  });

  it('a wrong decision belongs to the entry before it', async () => {
    const eventsAt = (x: number): readonly Event[] => [
      { e: 'pixel', at: 'L6', x, y: 1, z: 0.5, stored: 0.5, shown: false, exact: true },
      { e: 'disagree', at: 'L6', of: 'nearer', taken: false, exact: true, cause: 'rounded' },
    ];
    const events: readonly Event[] = [
      { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
      { e: 'call', at: 'Z14', of: 'ShowLine' },
      { e: 'line', at: 'L1', row: 1, from: [0, 0.5], to: [8, 0.5] },
      ...eventsAt(2),
      ...eventsAt(3),
      { e: 'span', at: 'Z14', row: 1, runs: [], depths: [] },
    ];
    const history = await readHistory(textWith(headerOf('zbuffer'), events), [3, 1]);
    expect(steps(history)).toEqual([
      [3, 'note'],
      [6, 'fail'],
      [7, 'wrong'],
      [8, 'fail'],
    ]);
    expect(history.painter).toBeNull();
  });
});
