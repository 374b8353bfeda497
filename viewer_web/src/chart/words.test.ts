import { describe, expect, it } from 'vitest';
import { chartComplaint, chartTexts } from '../i18n/chart.js';
import { languages } from '../language/language.js';
import { runOf, sample, sceneOf } from '../testing/charts.js';
import { Refusal } from '../trace/refusal.js';
import { formatChoice, parseChoice } from './choice.js';
import { sceneCosts, sceneErrors } from './scene-format.js';
import { duration, number, percent, whole } from './numbers.js';
import { allSeries, isVariant, look, lookOf } from './series.js';
import { shownOf } from './shown.js';
import { explanation, missingText, pointLines, runName } from './words.js';

/** A text with ordinary spaces in place of non-breaking ones. */
const plain = (text: string): string => text.replace(/[\u00a0\u202f]/gu, ' ');

describe('numbers', () => {
  it.each([
    [0, '0', '0'],
    [1, '1', '1'],
    [12.345, '12.3', '12,3'],
    [0.0012, '0.0012', '0,0012'],
    [12345, '12,300', '12 300'],
    [2e6, '2×10⁶', '2·10⁶'],
    [1e15, '10¹⁵', '10¹⁵'],
    [0.000123, '1.23×10⁻⁴', '1,23·10⁻⁴'],
    [Infinity, '∞', '∞'],
  ])('%d', (value, en, ru) => {
    expect([number(value, 'en'), plain(number(value, 'ru'))]).toEqual([en, ru]);
  });

  it('have units as the language writes them', () => {
    expect(percent(0.0123, 'en')).toBe('1.23%');
    expect(plain(percent(0.0123, 'ru'))).toBe('1,23 %');
    expect(plain(duration(0.00123, 'en'))).toBe('1.23 ms');
    expect(plain(duration(0.00000123, 'ru'))).toBe('1,23 мкс');
    expect(plain(duration(2.5, 'ru'))).toBe('2,5 с');
    expect(plain(whole(1234567, 'ru'))).toBe('1 234 567');
  });
});

describe('the address', () => {
  it('is parsed to the same choice', () => {
    const choice = {
      language: 'ru',
      view: 'ordinary/Roofs <and> hills & a=b',
      cost: 'bits',
      error: 'depthUlps',
      series: 'warnock-bits',
    } as const;
    expect(parseChoice(formatChoice(choice))).toEqual(choice);
  });

  it.each(['', '#', '#%%%', '#lang=xx&cost=__proto__&error=1&series=x%20y'])(
    'takes no nonsense: %s',
    (hash) => {
      expect(parseChoice(hash)).toEqual({
        language: null,
        view: null,
        cost: null,
        error: null,
        series: null,
      });
    },
  );
});

describe.each(languages)('in %s', (language) => {
  const all = sceneCosts.flatMap((cost) => sceneErrors.map((error) => ({ cost, error })));

  it.each(all)('all texts exist for $cost and $error', ({ cost, error }) => {
    for (const view of [null, 'ordinary/Two walls', 'degenerate/Slivers']) {
      const choice = { ...parseChoice(''), view, cost, error };
      const shown = shownOf(sample, choice, language);
      if (shown === null) throw new Error('nothing is shown');
      const said = [
        explanation(shown),
        missingText(shown) ?? '',
        ...shown.points.flatMap((point) => pointLines(point, shown)),
      ];
      expect(said.join('\n')).not.toMatch(/undefined|null|NaN|\[object|\$\{/);
      expect(explanation(shown)).toMatch(/^\p{Lu}.*\.$/u);
    }
  });

  it('a complaint names file, place and reason', () => {
    const refusal = new Refusal('scenes[0].runs', 'missing');
    expect(chartComplaint('x.json', refusal, language)).toMatch(
      /x\.json.*scenes\[0\]\.runs: .*\.$/,
    );
    expect(chartTexts[language].unreadable('x', '', 'y')).not.toContain(': ');
  });
});

describe('a variant of an algorithm', () => {
  const variant = runOf({ method: 'warnock-bodies', kernel: 'exact' });
  const chart = {
    ...sample,
    scenes: [sceneOf([runOf({}), variant], { name: 'A cube' }), sceneOf([runOf({})])],
  };

  it('is named with its kernel', () => {
    const inEnglish = shownOf(chart, parseChoice(''), 'en');
    const inRussian = shownOf(chart, parseChoice(''), 'ru');
    expect(inEnglish && runName(variant, inEnglish)).toBe('Warnock: closed bodies, exact');
    expect(inRussian && runName(runOf({}), inRussian)).toBe('Z-буфер double');
  });

  it('that does not take every scene is named among the missing runs', () => {
    const shown = shownOf(chart, parseChoice(''), 'en');
    expect(shown && missingText(shown)).toBe(
      'Not shown because some scenes have no number for them: Warnock: closed bodies.',
    );
  });

  it('has a symbol of its own', () => {
    const variants = allSeries.filter(({ group }) => isVariant(group));
    const shapes = variants.map((series) => lookOf(series).shape);
    expect(new Set(shapes).size).toBe(6);
    expect(shapes).not.toContain(look(runOf({ method: 'warnock' })).shape);
  });
});

describe('a point', () => {
  const shownIn = (view: string, language: 'en' | 'ru'): readonly string[] => {
    const choice = { ...parseChoice(''), view };
    const shown = shownOf(sample, choice, language);
    const point = shown?.points.find(({ setting }) => setting.kernel === 'bits:4');
    if (!shown || !point) throw new Error('no such point');
    expect(shown.visible).not.toContain(point);
    return pointLines(point, shown).map(plain);
  };

  it('is described with its counts', () => {
    const run = sample.scenes[0]?.runs.find(({ kernel }) => kernel === 'bits:4');
    expect(shownIn('ordinary/Two walls', 'en')).toEqual([
      'Warnock bits:4',
      'arithmetic of 4 bits',
      `Time: ×${number(run?.time ?? 0, 'en')} (${plain(duration(run?.seconds ?? 0, 'en'))})`,
      `Wrong pixels: ${percent((run?.wrongPixels ?? 0) / 1024, 'en')} (${String(run?.wrongPixels)} of 1,024)`,
    ]);
  });

  it('of several scenes is described with means', () => {
    const [name, details, ...amounts] = shownIn('ordinary', 'ru');
    expect([name, details]).toEqual(['Варнок bits:4', 'арифметика, бит: 4']);
    expect(amounts).toEqual([
      expect.stringMatching(/^Время: ×[\d,]+$/),
      expect.stringMatching(/^Неверные пиксели: [\d,]+ %$/),
    ]);
  });
});
