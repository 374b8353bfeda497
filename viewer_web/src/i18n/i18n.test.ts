import { describe, expect, it } from 'vitest';
import { sentence } from '../algorithm/sentence.js';
import { emptyFloatingHorizon } from '../floating-horizon/state.js';
import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { short, shortApart, toNumber } from '../language/words.js';
import type { Values, Warnock } from '../replay/values.js';
import { Unreadable } from '../replay/trace.js';
import { allSamples } from '../testing/samples.js';
import { tellerOf } from '../testing/teller.js';
import { headerOf, parseHeader } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { emptyWarnock } from '../warnock/state.js';
import { emptyWeilerAtherton } from '../weiler-atherton/state.js';
import { emptyZBuffer } from '../zbuffer/state.js';
import { complaint, texts } from './index.js';

const header = parseHeader(headerOf('warnock'));
const apl = { entries: [['A', false]] as const };
const values: Values = {
  step: 1,
  calls: [],
  warnock: { ...emptyWarnock, window: [0, 0, 4, 4], apl },
  zbuffer: { ...emptyZBuffer, polygon: 'A' },
  floatingHorizon: { ...emptyFloatingHorizon, curve: 0 },
  weilerAtherton: emptyWeilerAtherton,
};
const say = (event: Event, language: Language): string =>
  sentence(event, values, values, { ...header, method: tellerOf(event) }, language);

describe.each(languages)('in %s', (language) => {
  it.each(allSamples.map((event) => [event.e, event] as const))(
    '%s is one sentence',
    (_e, event) => {
      const said = say(event, language);
      expect(said).toMatch(/^[\p{Lu}\d].*[.?]$/u);
      expect(said).not.toMatch(/undefined|null|NaN|\[object|\s\s| \./);
    },
  );

  it('each reason has a text', () => {
    for (const reason of Object.values(texts[language].reasons)) {
      const speak = reason;
      expect(speak('1', '2', '3')).toMatch(/\p{L}/u);
    }
  });
});

describe('sentences', () => {
  const nearer: Event = { e: 'nearer', at: 'PW6', polygon: 'B', corners: ['lb', 'lt'], k: 2 };

  it('name corners by their place on the screen', () => {
    expect(say(nearer, 'en')).toBe('B is nearer at 2 of 4 corners (top left, bottom left).');
    expect(say(nearer, 'ru')).toBe('B ближе в 2 из 4 углов (левый верхний, левый нижний).');
  });

  it('name the only polygon if the trace identifies it', () => {
    const decide: Event = { e: 'decide', at: 'W10', case: 'single' };
    expect(say(decide, 'en')).toBe('Only A is left in the window: background first, then A.');
    const both = { entries: [...apl.entries, ['B', false]] as const };
    const coarse = { ...values, warnock: { ...emptyWarnock, apl: both } };
    expect(sentence(decide, coarse, coarse, header, 'en')).toBe(
      'Only one polygon is left in the window: background first, then the polygon.',
    );
  });

  it('name the polygon that hides everything, and the one that it no longer hides', () => {
    const uncover: Event = { e: 'uncover', at: 'PW7', polygon: 'B' };
    const covered = { ...values, warnock: { ...emptyWarnock, hasSurround: true, covering: 'A' } };
    expect(sentence(uncover, covered, values, header, 'en')).toBe(
      'B is nearer somewhere, so A no longer hides everything.',
    );
    expect(sentence(uncover, covered, values, header, 'ru')).toBe(
      'B где-то ближе, и A больше не закрывает всего.',
    );
    expect(say(uncover, 'en')).toMatch(/nothing is known to hide/u);
    const surrounded: Event = { e: 'decide', at: 'W8', case: 'surrounded' };
    expect(sentence(surrounded, covered, covered, header, 'en')).toMatch(/^A hides everything/u);
  });

  it('use the plural forms of the language', () => {
    const fill = (n: number): Event => ({
      e: 'fill',
      at: 'W8',
      rect: [0, 0, n, 1],
      color: '#112233',
    });
    const said = [1, 2, 5, 21].map((n) => say(fill(n), 'ru'));
    expect(said).toEqual([
      '1 пиксель получает цвет A.',
      '2 пикселя получают цвет A.',
      '5 пикселей получают цвет A.',
      '21 пиксель получает цвет A.',
    ]);
    expect(say(fill(1), 'en')).toBe('1 pixel takes the colour of A.');
  });
});

describe('a colour', () => {
  // A and B have the same colour, and C has that of the background.
  const twins = parseHeader({
    ...headerOf('warnock'),
    scene: {
      format: 'vidno-scene/1',
      window: { x: 0, y: 0, width: 8, height: 8 },
      background: '#ffffff',
      polygons: ['A', 'B', 'C'].map((id) => ({
        id,
        color: id === 'C' ? '#ffffff' : '#112233',
        vertices: [
          [0, 0, 0],
          [8, 0, 0],
          [8, 8, 0],
        ],
      })),
    },
  });
  const coarse = { ...twins, detail: 'windows' as const };
  const shared = '#112233';
  const saying = (event: Event, warnock: Partial<Warnock>, of = twins): readonly string[] => {
    const known = { ...values, warnock: { ...emptyWarnock, ...warnock } };
    return languages.map((language) => sentence(event, known, known, of, language));
  };
  const color = (seen: string): Event => ({
    e: 'color',
    at: 'W9',
    point: [0.5, 0.5],
    color: seen,
  });
  const fill = (at: Event<'fill'>['at'], seen: string): Event => ({
    e: 'fill',
    at,
    rect: [0, 0, 2, 1],
    color: seen,
  });

  it('is attributed to the polygon that PointColor found, not to one with the same colour', () => {
    const ofB = { nearest: { polygon: 'B', z: 0.5 } };
    expect(saying(color(shared), ofB)).toEqual([
      'At (0.5, 0.5) the viewer sees B.',
      'В точке (0,5; 0,5) виден B.',
    ]);
    expect(saying(fill('W9', shared), ofB)[0]).toBe('2 pixels take the colour of B.');
    expect(saying(color('#ffffff'), { nearest: { polygon: 'C', z: 0.5 } })[0]).toMatch(
      /sees C\.$/u,
    );
    expect(saying(color('#ffffff'), {})[0]).toMatch(/sees the background\.$/u);
  });

  it('is attributed to nobody if the trace contradicts itself', () => {
    const ofB = { nearest: { polygon: 'B', z: 0.5 } };
    expect(saying(color('#ffffff'), ofB)[0]).toBe('At (0.5, 0.5) the viewer sees #ffffff.');
    expect(saying(fill('W9', '#ffffff'), ofB)).toEqual([
      '2 pixels take the colour #ffffff.',
      '2 пикселя получают цвет #ffffff.',
    ]);
  });

  it('is attributed to the polygon that hides the others', () => {
    expect(saying(fill('W8', shared), { covering: 'B' })).toEqual([
      '2 pixels take the colour of B.',
      '2 пикселя получают цвет B.',
    ]);
    const joined = { surrounding: [{ polygon: 'B', level: 0 }], outside: [] };
    expect(saying(fill('WF9', shared), { joined })[0]).toMatch(/of B\.$/u);
    expect(saying(fill('W7', '#ffffff'), {})[0]).toMatch(/take the background\.$/u);
  });

  it('is attributed to all polygons that have it if the trace does not identify one', () => {
    expect(saying(fill('W8', shared), {}, coarse)).toEqual([
      '2 pixels take the colour that A and B share.',
      '2 пикселя получают общий цвет A и B.',
    ]);
    expect(saying(fill('W9', '#ffffff'), {}, coarse)[0]).toMatch(
      /that C and the background share/u,
    );
    expect(saying(fill('W8', '#abcdef'), {}, coarse)[0]).toMatch(/the colour #abcdef\.$/u);
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
