import { describe, expect, it } from 'vitest';
import { sentence } from '../algorithm/sentence.js';
import { texts } from '../i18n/index.js';
import { headerOf, parseHeader } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import type { Language } from './language.js';

const header = parseHeader(headerOf('zbuffer'));
const nothing = {};
const say = (event: Event, language: Language): string =>
  sentence(event, nothing, nothing, header, language);

describe('numbers', () => {
  it('have a decimal comma in Russian, and semicolons between coordinates', () => {
    const { short, whole, inFull, list, point, windowText, shortApart } = texts.ru.numbers;
    expect([short(-2.667), short('1/3'), short(8)]).toEqual(['−2,667', '1/3', '8']);
    expect(point([6.5, 2])).toBe('(6,5; 2)');
    expect(windowText([0, 2.5, 4, 4])).toBe('(0; 2,5) 4 × 4');
    expect([whole('-inf'), whole(-0.05859375372529)]).toEqual(['−∞', '−0,05859375372529']);
    expect([inFull(0.1), list([0.5, 1 / 3])]).toEqual(['0,1', '0,5; ≈0,3333']);
    expect(shortApart(0.25, 0.5)).toEqual(['0,25', '0,5']);
    expect(texts.en.numbers.point([6.5, 2])).toBe('(6.5, 2)');
    expect([texts.en.page.rate(0.5), texts.ru.page.rate(0.5)]).toEqual(['0.5/s', '0,5/с']);
  });

  it('have the same format in sentences', () => {
    const event = { e: 'slope', at: 'L4', dz: -0.125 } as unknown as Event;
    expect(say(event, 'en')).toBe('From pixel to pixel z changes by −0.125.');
    expect(say(event, 'ru')).toBe('От пикселя к пикселю z меняется на −0,125.');
  });
});

describe('edges that end', () => {
  const drop = (...edges: number[]): Event =>
    ({ e: 'ael_drop', at: 'Z13', edges, next: 7.5 }) as unknown as Event;

  it.each<[Language, string, string]>([
    ['en', 'Edge 1 ends here and leaves the AEL', 'Edges 2, 1 and 0 end here and leave the AEL'],
    [
      'ru',
      'Ребро 1 заканчивается и удаляется из AEL',
      'Рёбра 2, 1 и 0 заканчиваются и удаляются из AEL',
    ],
  ])('are named, one or several (%s)', (language, one, several) => {
    expect(say(drop(1), language)).toContain(one);
    expect(say(drop(2, 1, 0), language)).toContain(several);
  });
});
