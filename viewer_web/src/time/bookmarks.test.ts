import { describe, expect, it } from 'vitest';
import {
  bookmarksUpTo,
  cleanNote,
  formatBookmarks,
  longestNote,
  marked,
  mostBookmarks,
  parseBookmarks,
  withBookmark,
  withoutBookmark,
} from './bookmarks.js';
import type { Bookmarks } from './bookmarks.js';

const three: Bookmarks = [
  { step: 4, note: 'first split' },
  { step: 17, note: '' },
  { step: 120, note: 'здесь ошибка: 1/3 ≠ 0.333' },
];

const full: Bookmarks = Array.from({ length: mostBookmarks }, (_, step) => ({ step, note: '' }));

describe('bookmarks', () => {
  it('are sorted by step', () => {
    const [a, b, c] = three;
    const list = [c, a, b].reduce<Bookmarks>(
      (all, each) => (each ? withBookmark(all, each.step, each.note) : all),
      [],
    );
    expect(list).toEqual(three);
  });

  it('are unique per step: a new note replaces the old one', () => {
    expect(withBookmark(three, 17, 'new')).toEqual([three[0], { step: 17, note: 'new' }, three[2]]);
  });

  it('keep their note when their step is marked again', () => {
    expect(marked(three, 4)).toEqual(three);
    expect(marked(three, 5)[1]).toEqual({ step: 5, note: '' });
  });

  it('are removed by their step', () => {
    expect(withoutBookmark(three, 17)).toEqual([three[0], three[2]]);
    expect(withoutBookmark(three, 18)).toEqual(three);
  });

  it('are limited in number, yet their notes may change', () => {
    expect(withBookmark(full, 99, 'one more')).toBe(full);
    expect(withBookmark(full, 3, 'note')).toHaveLength(mostBookmarks);
    expect(withBookmark(full, 3, 'note')[3]).toEqual({ step: 3, note: 'note' });
  });

  it('lie within the run, not after its end', () => {
    expect(bookmarksUpTo(three, 119)).toEqual(three.slice(0, 2));
    expect(bookmarksUpTo(three, 120)).toBe(three);
  });
});

describe('a note', () => {
  it.each([
    ['two\nlines\tof  text ', 'two lines of  text'],
    ['\u202egnol\u202c', 'gnol'],
    ['a\u0000\u001b[31mb', 'a [31mb'],
    ['<img src=x onerror=alert(1)>', '<img src=x onerror=alert(1)>'],
    ['\ud800', ''],
  ])('%j is kept as %j', (note, kept) => {
    expect(cleanNote(note)).toBe(kept);
  });

  it('is cut at its limit, but not within a character', () => {
    expect(cleanNote('x'.repeat(longestNote + 1))).toHaveLength(longestNote);
    const odd = `x${'𝛼'.repeat(longestNote)}`; // each 𝛼 takes two code units
    expect(cleanNote(odd)).toBe(`x${'𝛼'.repeat(longestNote / 2 - 1)}`);
  });
});

describe('in a link', () => {
  it('they are restored unchanged', () => {
    expect(parseBookmarks(formatBookmarks(three))).toEqual(three);
    expect(parseBookmarks(formatBookmarks([]))).toEqual([]);
  });

  it('they are base64 of lines, in the alphabet for links', () => {
    // printf '4 a\n30 b>?' | base64 is NCBhCjMwIGI+Pw==
    const two = [
      { step: 4, note: 'a' },
      { step: 30, note: 'b>?' },
    ];
    expect(formatBookmarks(two)).toBe('NCBhCjMwIGI-Pw');
  });

  it('they are never long, whatever their notes', () => {
    const greatest = full.map((_, i) => ({ step: 4_000_000 - i, note: '漢'.repeat(longestNote) }));
    const sorted = greatest.reverse();
    const written = formatBookmarks(sorted);
    expect(written.length).toBeLessThanOrEqual(4096);
    expect(parseBookmarks(written)).toEqual(sorted);
  });

  const written = (text: string): string => Buffer.from(text, 'utf8').toString('base64url');

  it.each([
    ['a note without a step', 'note', []],
    ['a step that is none', '-4 a\n1e3 b\n1.5 c\n9999999999 d\n5 e', [{ step: 5, note: 'e' }]],
    ['a step twice', '5 a\n5 b', [{ step: 5, note: 'b' }]],
    ['a step alone', '5', [{ step: 5, note: '' }]],
    ['a long note', `5 ${'x'.repeat(500)}`, [{ step: 5, note: 'x'.repeat(longestNote) }]],
  ])('%s gives the valid bookmarks', (_what, text, bookmarks) => {
    expect(parseBookmarks(written(text))).toEqual(bookmarks);
  });

  it('only the allowed number is read', () => {
    const lines = Array.from({ length: 40 }, (_, step) => `${step} x`);
    expect(parseBookmarks(written(lines.join('\n')))).toHaveLength(mostBookmarks);
  });

  it.each(['*', 'A', '_w', 'x'.repeat(5000), '\u0000'])('nonsense is nothing', (nonsense) => {
    expect(parseBookmarks(nonsense)).toEqual([]);
  });
});
