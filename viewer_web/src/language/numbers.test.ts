import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';

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
});
