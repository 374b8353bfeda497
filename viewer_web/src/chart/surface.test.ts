import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { curveRunOf, sample, surfaceOf, surfaceSample } from '../testing/charts.js';
import { adviceText } from './advice-words.js';
import { adviceOf } from './advice.js';
import { parseChoice } from './choice.js';
import type { Choice } from './choice.js';
import { look, seriesId } from './series.js';
import { shownOf } from './shown.js';
import type { Shown } from './shown.js';
import { curveCosts, curveErrors, curveKernels } from './surface-format.js';
import { explanation, missingText, pointLines, runName, sizeText } from './words.js';

/** A text with ordinary spaces in place of non-breaking ones. */
const plain = (text: string): string => text.replace(/[\u00a0\u202f]/gu, ' ');

function shown(
  choice: Partial<Choice>,
  language: Language = 'en',
  chart: Parameters<typeof shownOf>[0] = surfaceSample,
): Shown {
  const found = shownOf(chart, { ...parseChoice(''), ...choice }, language);
  if (found === null) throw new Error('nothing is shown');
  return found;
}

const peak = { view: 'surfaces/A peak between two samples' } as const;

describe('the axes', () => {
  it('are those of the chart; an unknown choice counts as none', () => {
    const of = ({ cost, error }: Shown): readonly string[] => [cost, error];
    expect(of(shown({ cost: 'samples', error: 'height' }))).toEqual(['samples', 'height']);
    expect(of(shown({ cost: 'bits', error: 'area' }))).toEqual(['time', 'wrongColumns']);
    const scenes = shown({ cost: 'samples', error: 'wrongDecisions' }, 'en', sample);
    expect(of(scenes)).toEqual(['time', 'wrongDecisions']);
  });
});

describe('the series', () => {
  it('are of a kernel and a knob, a colour and a size for each kernel', () => {
    const runs = curveKernels.map((kernel) => curveRunOf({ kernel, knob: 'samples', value: 3 }));
    expect(runs.map(seriesId)).toEqual([
      'float-samples',
      'double-samples',
      'filtered-samples',
      'exact-samples',
    ]);
    const looks = runs.map(look);
    expect(new Set(looks.map(({ color }) => color)).size).toBe(4);
    const scales = looks.map(({ scale }) => scale);
    // The symbols overlap: the largest is drawn first.
    expect(scales).toEqual([...new Set(scales)].sort((a, b) => b - a));
  });
});

/** Three level curves over 33 columns; the middle one has a peak 4 columns wide, which hides one column of the last. */
describe('the peak between two samples', () => {
  const told = (kernel: string, value: number): readonly string[] => {
    const all = shown({ ...peak, cost: 'samples', error: 'height' });
    const point = all.points.find(
      ({ setting }) =>
        setting.kernel === kernel && setting.value === value && setting.edition === 'corrected',
    );
    return point === undefined ? [] : pointLines(point, all).map(plain);
  };

  it('is missed by 9 samples per curve, but not by 10 adaptive ones in all', () => {
    expect(told('double', 9)).toEqual([
      'double, 9 samples per curve',
      'corrected',
      'Samples: 27',
      'Height missed: 6 px',
    ]);
    expect(told('exact', 0.5)).toEqual([
      'exact, tolerance 0.5 px',
      'corrected',
      'Samples: 10',
      'Height missed: 0 px',
    ]);
    expect(sizeText(shown(peak))).toMatch(/^curves: 3 · columns of all curves: 99 · /u);
  });

  it('needs a tolerance below its height, or an even sample on every second column', () => {
    const advice = adviceOf(surfaceSample.surfaces.slice(0, 1), 'samples');
    expect(advice?.cheapest.setting).toMatchObject({ knob: 'tolerance', value: 4 });
    expect(advice?.safe?.setting).toMatchObject({ kernel: 'filtered', value: 4 });
    // These are 2 and 3 samples per curve and the tolerances 16 and 8, under four kernels.
    expect(advice?.cheaper).toHaveLength(4 * 4);
    // The corners are over the columns 8, 10 and 12. 17 samples per curve include them: 51 instead of 10.
    expect(advice?.others.map(({ setting, cost }) => [setting.value, cost])).toEqual([[17, 51]]);
    expect(advice?.neverRight).toEqual(['fixed']);
    expect(advice?.losses).toEqual({ height: 0, decisions: new Map() });
  });

  it.each([
    [
      'en',
      /^“filtered, tolerance 4 px” .*\(samples 10\)\. .*: 16, .* 1\.01% of the columns\. Its curves match the function/u,
    ],
    [
      'ru',
      /^«filtered, допуск 4 пикс\.» .*\(отсчёты: 10\)\. .*: 16, .* 1,01 % столбцов\. Его кривые ни над/u,
    ],
  ] as const)('is explained in %s', (language, text) => {
    const all = shown({ ...peak, cost: 'samples' }, language);
    expect(plain(adviceText(adviceOf(all.view.subjects, 'samples'), all))).toMatch(text);
  });
});

describe('what a surface loses', () => {
  it('is height between the samples, and decisions by arithmetic', () => {
    const runs = [
      curveRunOf({ kernel: 'float', time: 3, wrongDecisions: 1 }),
      curveRunOf({ kernel: 'float', time: 2, height: 0.25, wrongDecisions: 2 }),
      curveRunOf({ kernel: 'float', edition: 'printed', wrongDecisions: 9 }),
      curveRunOf({ kernel: 'double', time: 1, wrongColumns: 1 }),
    ].map((run, value) => ({ ...run, knob: 'samples' as const, value }));
    const advice = adviceOf([surfaceOf(runs)], 'time');
    expect(advice?.cheapest.run).toBe(runs[1]);
    expect(advice?.losses).toEqual({ height: 0.25, decisions: new Map([['float', 0.2]]) });
    const all = shown({}, 'en', { ...surfaceSample, surfaces: [surfaceOf(runs)] });
    expect(adviceText(advice, all)).toMatch(/at most 0\.25 px from the function.*: float \(20%\)/u);
  });

  it('is not stated for scenes', () => {
    expect(adviceOf(sample.scenes, 'time')?.losses).toBeNull();
  });
});

describe('surfaces together', () => {
  it('leave out samplings that not all of them have', () => {
    const all = shown({ cost: 'samples' });
    // 33 columns allow 17 and 33 samples, 9 columns do not.
    expect(missingText(all)).toBe(
      'Not shown because some surfaces were not sampled that way: 17 samples per curve, 33 samples per curve.',
    );
    expect(sizeText(all)).toBeNull();
    expect(runName(curveRunOf({}), all)).toBe('double, as given');
  });
});

describe.each(languages)('in %s', (language) => {
  const views = [null, peak.view, 'surfaces/Ramp <up> & down'];
  const all = curveCosts.flatMap((cost) => curveErrors.map((error) => ({ cost, error })));

  it.each(all)('all texts exist for $cost and $error', ({ cost, error }) => {
    for (const view of views) {
      const found = shown({ view, cost, error }, language);
      const said = [
        explanation(found),
        missingText(found) ?? '',
        sizeText(found) ?? '',
        adviceText(adviceOf(found.view.subjects, cost), found),
        ...found.points.flatMap((point) => pointLines(point, found)),
      ];
      expect(said.join('\n')).not.toMatch(/undefined|null|NaN|\[object|\$\{/u);
      expect(explanation(found)).toMatch(/^\p{Lu}.*\.$/u);
      expect(said[3]).toMatch(/\.$/u);
    }
  });
});
