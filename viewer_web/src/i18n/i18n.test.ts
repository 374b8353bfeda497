import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import { sentencesOf } from '../language/stated.js';
import { short, shortApart, toNumber } from '../language/words.js';
import { Unreadable } from '../replay/trace.js';
import { faultOfForm } from '../testing/facts/shown.js';
import { textOf, traceNames, traceOf } from '../testing/traces.js';
import { complaint, texts } from './index.js';

describe.each(languages)('in %s', (language) => {
  it.each(traceNames)('each step of %s is one sentence', async (name) => {
    const { timeline } = await traceOf(textOf(name));
    for (let step = 1; step <= timeline.length; step++) {
      const said = timeline.sentence(step, language);
      for (const sentence of sentencesOf(said)) expect(faultOfForm(sentence), said).toBeNull();
    }
  });

  it('each reason has a text', () => {
    for (const reason of Object.values(texts[language].reasons)) {
      const speak = reason;
      expect(speak('1', '2', '3')).toMatch(/\p{L}/u);
    }
  });
});

describe('numbers', () => {
  it.each([
    [0.5, '0.5'],
    [-2, '−2'],
    [0.1 + 0.2, '≈0.3'],
    [1 / 3, '≈0.3333'],
    [1e-9 / 3, '≈3.33e−10'],
    [-1e-9, '−1e−9'],
    [-0.0390625, '≈−0.039'], // with its sign it has room for seven characters
    [NaN, 'NaN'],
    ['-inf', '−∞'],
    ['1/10', '1/10'],
    ['-3/1', '−3'],
    ['-1000000000000000000001/3000000000000000000000', '≈−0.333'],
    ['nan', 'nan'],
    ['1/0', '1/0'],
  ] as const)('%s is shown as %s', (value, shown) => {
    expect(short(value)).toBe(shown);
  });

  it('are plotted by their value', () => {
    expect([toNumber('1/4'), toNumber('-inf'), toNumber(2)]).toEqual([0.25, -Infinity, 2]);
  });
});

describe('a complaint', () => {
  it('names file, line, place and reason', () => {
    const error = new Unreadable('not a polygon of the scene', '/polygon', 3);
    expect(complaint('x.jsonl', error, 'en')).toBe(
      'x.jsonl cannot be read as a trace. Line 3, /polygon: not a polygon of the scene.',
    );
    expect(complaint('x.jsonl', error, 'ru')).toBe(
      'Файл x.jsonl не читается как трасса. Строка 3, /polygon: такого многоугольника в сцене нет.',
    );
  });
});

describe('numbers that are compared', () => {
  it('are short if that distinguishes them, or else in full', () => {
    expect(shortApart(0.5, 0.25)).toEqual(['0.5', '0.25']);
    expect(shortApart(-0.0585937462747097, -0.05859375)).toEqual([
      '−0.0585937462747097',
      '−0.05859375',
    ]);
    expect(shortApart(0.123456789, 0.123456789)).toEqual(['≈0.1235', '≈0.1235']);
    expect(shortApart('1234567/7654321', '1234568/7654321')).toEqual([
      '1234567/7654321',
      '1234568/7654321',
    ]);
  });

  it('are never longer than a sentence', () => {
    const digits = '1'.repeat(50);
    const [one, other] = shortApart(`${digits}1/${digits}3`, `${digits}2/${digits}3`);
    expect(one.length + other.length).toBeLessThan(30);
  });
});
