import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import { runOf, sample, sceneOf } from '../testing/charts.js';
import { adviceText } from './advice-words.js';
import { adviceOf, mostly } from './advice.js';
import { parseChoice } from './choice.js';
import { sceneCosts } from './scene-format.js';
import { shownOf } from './shown.js';

const wrongZBuffer = runOf({ kernel: 'float', time: 1, wrongPixels: 4 });
const rightZBuffer = runOf({ kernel: 'double', time: 2 });
const safeZBuffer = runOf({ kernel: 'filtered', time: 3 });
const exactZBuffer = runOf({ kernel: 'exact', time: 90 });
const rightWarnock = runOf({ method: 'warnock', kernel: 'double', time: 20 });

const kernels = (points: readonly { readonly setting: { readonly kernel: string } }[]): string[] =>
  points.map(({ setting }) => setting.kernel);

describe('which run a scene needs', () => {
  it('is the cheapest right one, and the others named have other methods', () => {
    const scene = sceneOf([exactZBuffer, rightWarnock, safeZBuffer, rightZBuffer, wrongZBuffer]);
    const advice = adviceOf([scene], 'time');
    expect(advice?.cheapest.run).toBe(rightZBuffer);
    expect(kernels(advice?.cheaper ?? [])).toEqual(['float']);
    expect(advice?.safe?.run).toBe(safeZBuffer);
    expect(advice?.others.map(({ run }) => run)).toEqual([rightWarnock]);
    expect(advice?.neverRight).toEqual([]);
  });

  it('is, among equally cheap ones, the one that is right everywhere', () => {
    const scene = sceneOf([rightZBuffer, { ...safeZBuffer, time: rightZBuffer.time }]);
    const advice = adviceOf([scene], 'time');
    expect(advice?.cheapest.setting.kernel).toBe('filtered');
    expect(advice?.safe).toBe(advice?.cheapest);
  });

  it('never names a snapping kernel as safe, for it is right about another scene', () => {
    const grid = runOf({ kernel: 'grid:8', time: 1 });
    const advice = adviceOf([sceneOf([grid, safeZBuffer])], 'time');
    expect(advice?.cheapest.run).toBe(grid);
    expect(advice?.safe?.run).toBe(safeZBuffer);
  });

  it('is never of an edition with defects, nor ended by a fault', () => {
    const printed = runOf({ edition: 'printed', time: 0.5 });
    const broken = runOf({ complete: false, time: 0.6 });
    const advice = adviceOf([sceneOf([printed, broken, rightZBuffer])], 'time');
    expect(advice?.cheapest.run).toBe(rightZBuffer);
    expect(advice?.cheaper).toEqual([]);
  });

  it('names the methods that are never right', () => {
    const wrong = runOf({ method: 'warnock', wrongPixels: 1 });
    expect(adviceOf([sceneOf([wrong, rightZBuffer])], 'time')?.neverRight).toEqual(['warnock']);
    expect(adviceOf([sceneOf([wrong])], 'time')).toBeNull();
  });

  it('holds for several scenes if it is right in each of them', () => {
    const first = sceneOf([rightZBuffer, safeZBuffer]);
    const second = sceneOf([{ ...rightZBuffer, wrongPixels: 1 }, safeZBuffer]);
    expect(adviceOf([first, second], 'time')?.cheapest.setting.kernel).toBe('filtered');
  });

  it('has no safe run if no run that is always right has the cost', () => {
    const scene = sceneOf([rightZBuffer, { ...safeZBuffer, bits: null }]);
    expect(adviceOf([scene], 'bits')?.safe).toBeNull();
  });
});

it('names the kind of most operations of a run', () => {
  const { counts } = wrongZBuffer;
  const run = runOf({ operations: 40, counts: { ...counts, comparisons: 10, orientations: 30 } });
  expect(mostly(run)).toEqual(['orientations', 0.75]);
  expect(mostly(runOf({ operations: 0, counts: { ...counts, comparisons: 0 } }))).toBeNull();
});

describe.each(languages)('the paragraph in %s', (language) => {
  const saidOf = (runs: Parameters<typeof sceneOf>[0]): string => {
    const chart = { ...sample, scenes: [sceneOf(runs)] };
    const shown = shownOf(chart, parseChoice(''), language);
    if (shown === null) throw new Error('nothing is shown');
    return adviceText(adviceOf(chart.scenes, 'time'), shown).replace(/[\u00a0\u202f]/gu, ' ');
  };

  it('says what is needed and why', () => {
    const said = saidOf([exactZBuffer, rightWarnock, safeZBuffer, rightZBuffer, wrongZBuffer]);
    // The cheaper run has 4 of 100 pixels wrong. The others cost 3 / 2 and 20 / 2 times as much.
    expect(said).toMatch(/double.*×2.*float.*4 ?%.*filtered.*×1[.,]5.*double \(×10; 100 ?%/u);
  });

  it('distinguishes runs that differ in their smallest window', () => {
    const coarse = runOf({
      method: 'warnock',
      window: 8,
      knob: 'window',
      value: 8,
      wrongPixels: 17,
    });
    expect(saidOf([{ ...coarse, time: 1 }, rightZBuffer])).toMatch(
      /double \([^)]* 8[^)]*\).* 17 ?%/u,
    );
  });

  it('differs where the cheapest is right everywhere', () => {
    expect(saidOf([safeZBuffer])).not.toBe(saidOf([rightZBuffer]));
    expect(saidOf([safeZBuffer]).split('.').length).toBeLessThan(5);
  });

  it.each(sceneCosts)('has words for %s of every scene', (cost) => {
    for (const view of [null, 'ordinary/Two walls', 'degenerate/Slivers']) {
      const shown = shownOf(sample, { ...parseChoice(''), view, cost }, language);
      if (shown === null) throw new Error('nothing is shown');
      const said = adviceText(adviceOf(shown.view.subjects, cost), shown);
      expect(said).not.toMatch(/undefined|null|NaN|\[object|\$\{/u);
      expect(said).toMatch(/\.$/u);
    }
  });
});
