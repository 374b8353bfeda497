import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { runOf, sample, sceneOf } from '../testing/charts.js';
import { adviceRows, adviceText } from './advice.js';
import { parseChoice } from './choice.js';
import type { SceneRun } from './scene-format.js';
import { sceneCosts } from './scene-format.js';
import { shownOf } from './shown.js';
import type { Shown } from './shown.js';

const wrongZBuffer = runOf({ kernel: 'float', time: 1, wrongPixels: 4 });
const rightZBuffer = runOf({ kernel: 'double', time: 2 });
const safeZBuffer = runOf({ kernel: 'filtered', time: 3 });
const exactZBuffer = runOf({ kernel: 'exact', time: 90 });
const rightWarnock = runOf({ method: 'warnock', kernel: 'double', time: 20 });
const fewBits = runOf({ kernel: 'bits:8', knob: 'bits', value: 8, time: 0.5 });
const slowVariant = runOf({ method: 'warnock-full', kernel: 'float', time: 9 });
const fastVariant = runOf({ method: 'warnock-simplest', kernel: 'float', time: 8 });
const wrongVariant = runOf({ method: 'weiler-atherton', time: 7, wrongPixels: 1 });

function shownWith(
  runs: readonly SceneRun[],
  language: Language = 'en',
  hash = '',
  fields: Parameters<typeof sceneOf>[1] = {},
): Shown {
  const shown = shownOf(
    { ...sample, scenes: [sceneOf(runs, fields)] },
    parseChoice(hash),
    language,
  );
  if (shown === null) throw new Error('nothing is shown');
  return shown;
}

const all = [
  exactZBuffer,
  slowVariant,
  rightWarnock,
  fewBits,
  safeZBuffer,
  rightZBuffer,
  fastVariant,
  wrongVariant,
  wrongZBuffer,
];

describe('the chart opens', () => {
  it('with the two methods, and the fastest right run of all others', () => {
    expect(shownWith(all).main.map(({ run }) => run)).toEqual([
      wrongZBuffer,
      rightZBuffer,
      safeZBuffer,
      fastVariant,
      rightWarnock,
      exactZBuffer,
    ]);
  });

  it('without the printed edition, and without runs that a fault ended', () => {
    const printed = runOf({ edition: 'printed', time: 0.5 });
    const broken = runOf({ complete: false, time: 0.6, kernel: 'filtered' });
    const { main } = shownWith([printed, broken, rightZBuffer]);
    expect(main.map(({ run }) => run)).toEqual([rightZBuffer]);
  });

  it('with at most twelve points, whatever the scene and the cost', () => {
    for (const view of ['ordinary', 'ordinary/Two walls', 'degenerate/Slivers']) {
      for (const cost of sceneCosts) {
        const shown = shownOf(sample, { ...parseChoice(''), view, cost }, 'en');
        expect(shown?.main.length).toBeGreaterThan(2);
        expect(shown?.main.length).toBeLessThanOrEqual(12);
      }
    }
  });

  it('and a series adds its own points only', () => {
    const { main, added, visible } = shownWith(all, 'en', 'series=zbuffer-bits');
    expect(added.map(({ run }) => run)).toEqual([fewBits]);
    expect(visible).toEqual([...main, ...added]);
    expect(shownWith(all, 'en', 'series=warnock-grid').added).toEqual([]);
  });
});

describe('the advice', () => {
  // The cheapest right main run costs 2; that with 8 bits is cheaper, but none of the main ones. Right everywhere costs 3.
  const rowsOf = (shown: Shown): unknown[] => adviceRows(shown).map(({ point }) => point?.run);

  it('names the cheapest right run, the one that is always right, and what is cheaper', () => {
    expect(rowsOf(shownWith(all))).toEqual([rightZBuffer, safeZBuffer, wrongZBuffer]);
  });

  it('names, of the cheaper runs, the least wrong one', () => {
    const closer = runOf({ method: 'warnock', kernel: 'float', time: 1.5, wrongPixels: 3 });
    expect(rowsOf(shownWith([closer, ...all]))[2]).toBe(closer);
  });

  it('prefers, among equally cheap runs, the one that is right everywhere', () => {
    const tied = { ...safeZBuffer, time: rightZBuffer.time };
    expect(rowsOf(shownWith([rightZBuffer, tied]))).toEqual([tied, tied, undefined]);
  });

  it('has no run that is right everywhere if none has the cost', () => {
    const shown = shownWith([rightZBuffer, { ...safeZBuffer, bits: null }], 'en', 'cost=bits');
    expect(rowsOf(shown)).toEqual([rightZBuffer, undefined, undefined]);
  });

  it('holds for several scenes if a run is right in each of them', () => {
    const scenes = [
      sceneOf([rightZBuffer, safeZBuffer]),
      sceneOf([{ ...rightZBuffer, wrongPixels: 1 }, safeZBuffer]),
    ];
    const shown = shownOf({ ...sample, scenes }, parseChoice(''), 'en');
    expect(shown?.answer.cheapest?.setting.kernel).toBe('filtered');
    expect(shown?.answer.wrong?.setting.kernel).toBe('double');
  });

  it('is right about pixels, whichever error the axis shows', () => {
    const shown = shownWith(all, 'en', 'error=depthUlps');
    expect(rowsOf(shown)).toEqual([rightZBuffer, safeZBuffer, wrongZBuffer]);
  });

  it('is one sentence', () => {
    // 3 / 2 = 1.5.
    expect(adviceText(shownWith(all))).toBe(
      'Z-buffer double is the cheapest right run; one that is right everywhere, not only here, costs 1.5 times as much.',
    );
    expect(adviceText(shownWith(all, 'ru'))).toBe(
      'Z-буфер double — самый дешёвый верный прогон; верный не только здесь, но и везде обойдётся дороже: ×1,5.',
    );
    expect(adviceText(shownWith([wrongZBuffer]))).toBe('No run shown gets every pixel right.');
  });

  it.each(languages)('is one sentence in %s for every cost and scene', (language) => {
    for (const view of ['ordinary', 'ordinary/Two walls', 'degenerate/Slivers']) {
      for (const cost of sceneCosts) {
        const shown = shownOf(sample, { ...parseChoice(''), view, cost }, language);
        expect(shown && adviceText(shown)).toMatch(/^[^.]*(\d[.,]\d[^.]*)?\.$/u);
        expect(shown && adviceRows(shown)).toHaveLength(3);
      }
    }
  });
});
