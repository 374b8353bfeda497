import { describe, expect, it } from 'vitest';
import { historyIn, last, say, steps } from '../testing/histories.js';

describe('in Warnock’s algorithm', () => {
  it('a pixel has the windows that contain it, nested', async () => {
    const history = await historyIn('small.warnock.windows', [4, 0]);
    expect(history.entries.map(({ step, event }) => [step, event.e])).toEqual([
      [1, 'push'],
      [2, 'pop'],
      [3, 'decide'],
      [4, 'push'],
      [38, 'pop'],
      [39, 'decide'],
      [41, 'push'],
      [80, 'pop'],
      [81, 'decide'],
      [84, 'push'],
      [89, 'pop'],
      [90, 'decide'],
      [91, 'fill'],
    ]);
    expect(history.why(last(history.entries), 'en')).toBe(
      'Why it has this colour: B surrounds this window and hides everything else in it.',
    );
    expect(history.why(last(history.entries), 'en', 90)).toBe(
      'Why it gets this colour at step 91: B surrounds this window and hides everything else in it.',
    );
  });

  it('a polygon that is clipped and misses the pixel leaves the background', async () => {
    const history = await historyIn('clipped.warnock.signs', [3, 2]);
    expect(steps(history)).toEqual([
      [2, 'note'],
      [3, 'note'],
      [6, 'pass'],
      [7, 'pass'],
      [12, 'pass'],
      [13, 'pass'],
      [14, 'pass'],
      [15, 'pass'],
      [16, 'pass'],
      [17, 'note'],
      [21, 'fail'],
      [22, 'fail'],
      [23, 'note'],
      [24, 'note'],
      [25, 'paint'],
      [74, 'pass'],
      [78, 'fail'],
      [79, 'fail'],
    ]);
    expect(say(last(history.entries), history)).toBe(
      'A does not cover the centre of this pixel, which stays as it is.',
    );
    const { painter } = history;
    expect(painter && history.why(painter, 'en')).toBe(
      'Why it is background: as this run computes it, the only polygon in this window does not cover the centre of the pixel.',
    );
  });

  it('a polygon that covers the pixel gives it its colour', async () => {
    const history = await historyIn('clipped.warnock.signs', [1, 2]);
    expect(steps(history).slice(-4)).toEqual([
      [25, 'paint'],
      [74, 'pass'],
      [78, 'pass'],
      [79, 'paint'],
    ]);
    expect(history.why(last(history.entries), 'en')).toBe(
      'Why it has this colour: A is alone in this window and covers the centre of the pixel.',
    );
  });

  it('the window of a single pixel has the findings about each polygon', async () => {
    const history = await historyIn('small.warnock.polygons', [6, 2]);
    const inLast = steps(history).filter(([step]) => step >= 89);
    expect(inLast).toEqual([
      [89, 'note'],
      [92, 'pass'],
      ...[93, 94, 95, 96].map((step) => [step, 'note']),
      [97, 'pass'],
      [98, 'note'],
      [99, 'pass'],
      [100, 'pass'],
      ...[101, 102, 103, 104].map((step) => [step, 'note']),
      [105, 'pass'],
      [106, 'note'],
      [107, 'fail'],
      [108, 'note'],
      [109, 'note'],
      [111, 'pass'],
      [112, 'note'],
      [113, 'pass'],
      [114, 'fail'],
      [115, 'note'],
      [116, 'paint'],
    ]);
    expect(history.why(last(history.entries), 'en')).toBe(
      'Why it has this colour: A is the nearest of all that cover its centre.',
    );
  });
});
