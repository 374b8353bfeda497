import { describe, expect, it } from 'vitest';
import { glued, withoutBadBreaks } from './glue.js';

const z = { is: 'formula', tex: 'z' } as const;

describe('a formula', () => {
  it('keeps adjacent punctuation on its line', () => {
    expect(glued(['at (', z, '), not'])).toEqual([
      'at ',
      { is: 'glued', before: '(', tex: 'z', after: '),' },
      ' not',
    ]);
  });

  it('keeps the rest of its word', () => {
    expect(glued([z, '-буфер и'])).toEqual([
      { is: 'glued', before: '', tex: 'z', after: '-буфер' },
      ' и',
    ]);
  });

  it('keeps the coordinates of a point together, and no other words', () => {
    expect(withoutBadBreaks('at (8; −6), (±1, 0) and (1/2, 0, 3) (or so, 4)')).toBe(
      'at (8;\u00a0−6), (±1,\u00a00) and (1/2,\u00a00,\u00a03) (or so, 4)',
    );
  });

  it('keeps the sides of an area together', () => {
    expect(withoutBadBreaks('a window of 4 × 4 pixels')).toBe('a window of 4\u00a0×\u00a04 pixels');
  });

  it('keeps a Russian number on one line', () => {
    expect(withoutBadBreaks('из 65 536 ответов верны 256')).toBe(
      'из 65\u00a0536 ответов верны 256',
    );
  });

  it('begins no line with a dash', () => {
    expect(withoutBadBreaks('Слева R, справа — P.')).toBe('Слева R, справа\u00a0— P.');
  });

  it('takes nothing from separate words or another formula', () => {
    const bare = { is: 'glued', before: '', tex: 'z', after: '' };
    expect(glued(['for ', z, z, ' and'])).toEqual(['for ', bare, bare, ' and']);
  });
});
