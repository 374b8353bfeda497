import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { curveRunOf, sample, surfaceSample } from '../testing/charts.js';
import { adviceText } from './advice.js';
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
  const saidOf = (kernel: string, value: number): readonly string[] => {
    const all = shown({ ...peak, cost: 'samples', error: 'height' });
    const point = all.points.find(
      ({ setting }) =>
        setting.kernel === kernel && setting.value === value && setting.edition === 'corrected',
    );
    return point === undefined ? [] : pointLines(point, all).map(plain);
  };

  it('is missed by 9 samples per curve, but not by 10 adaptive ones in all', () => {
    expect(saidOf('double', 9)).toEqual([
      'double, 9 samples per curve',
      'Samples: 27',
      'Height missed: 6 px',
    ]);
    expect(saidOf('exact', 0.5)).toEqual([
      'exact, tolerance 0.5 px',
      'Samples: 10',
      'Height missed: 0 px',
    ]);
    expect(sizeText(shown(peak))).toMatch(/^curves: 3 · columns of all curves: 99 · /u);
  });

  it('needs a tolerance below its height, or an even sample on every second column', () => {
    const { main, answer } = shown({ ...peak, cost: 'samples' });
    expect(answer.cheapest?.setting).toMatchObject({ knob: 'tolerance', value: 4 });
    expect(answer.safe?.setting).toMatchObject({ kernel: 'filtered', value: 4 });
    // The corners are over the columns 8, 10 and 12. 17 samples per curve include them: 51 instead of 10.
    const turned = main.filter(({ setting }) => setting.knob !== null);
    const densest = turned.filter(({ setting }) => setting.value === 33);
    expect(densest.map(({ setting }) => setting.kernel).sort()).toEqual([
      'double',
      'exact',
      'filtered',
      'float',
    ]);
    const fewer = turned.filter((point) => !densest.includes(point));
    expect(fewer.map(({ setting, cost }) => [setting.value, cost])).toEqual([
      [4, 10],
      [17, 51],
    ]);
    // Besides, the samples of the file under four kernels.
    expect(main).toHaveLength(4 + 4 + 2);
  });

  it.each([
    [
      'en',
      'filtered, tolerance 4 px is the cheapest right run, and it is right everywhere, since it decides as exact arithmetic does.',
    ],
    [
      'ru',
      'filtered, допуск 4 пикс. — самый дешёвый верный прогон, и он верен везде: его решения те же, что в точной арифметике.',
    ],
  ] as const)('is explained in %s', (language, text) => {
    expect(plain(adviceText(shown({ ...peak, cost: 'samples' }, language)))).toBe(text);
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
        adviceText(found),
        ...found.points.flatMap((point) => pointLines(point, found)),
      ];
      expect(said.join('\n')).not.toMatch(/undefined|null|NaN|\[object|\$\{/u);
      expect(explanation(found)).toMatch(/^\p{Lu}.*\.$/u);
      expect(said[3]).toMatch(/\.$/u);
    }
  });
});
