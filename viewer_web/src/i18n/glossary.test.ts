import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import { FirstTerms, glossary, wordsLike } from './glossary.js';

const root = fileURLToPath(new URL('../../../', import.meta.url));

/** What people read: README, documents, lessons, the page's strings, and the sources of help, messages and comments. */
const texts = execFileSync(
  'find',
  ['.', ...'-type f -not -path */node_modules/* -not -path ./build/*'.split(' ')],
  {
    cwd: root,
    encoding: 'utf8',
  },
)
  .split('\n')
  .map((file) => file.slice(2))
  .filter(
    (file) =>
      (/^(?:README|CHANGELOG|COMPATIBILITY|CONTRIBUTING)\.md$/.test(file) ||
        /^(?:lessons|trace)\/.*\.md$/.test(file) ||
        /^viewer_web\/src\/i18n\/(?:en|ru)\//.test(file) ||
        /^(?:trace|lib)\/.*\.(?:cpp|h|json)$/.test(file)) &&
      file !== 'lessons/GLOSSARY.md',
  )
  .sort();

/** A sentence's first words, at the start of a line, after a full stop, or at the start of a quoted string. */
const start =
  /(?:^\s*(?:[-*>|]\s*)*|[.!?:] |["'`>|]\s?)(?:Of|Who|Whoever|That (?:a|an|the)) \p{Ll}\S*/gu;

const phrases = [
  'so many',
  'so manieth',
  'is told',
  'are told',
  'gone round',
  'goes round',
  'is there twice',
  'to reach over',
  'as far as told',
  'in hand',
  'to it that',
  'of itself',
];
/** The places, as file:line, where a text matches. */
function places(lines: readonly string[], file: string, pattern: RegExp): readonly string[] {
  return lines.flatMap((line, i) =>
    [...line.matchAll(pattern)].map(([found]) => `${file}:${i + 1}: ${found.trim()}`),
  );
}

function allPlaces(pattern: RegExp, inLowerCase = false): readonly string[] {
  return texts.flatMap((file) => {
    const text = readFileSync(root + file, 'utf8');
    return places((inLowerCase ? text.toLowerCase() : text).split('\n'), file, pattern);
  });
}

describe('the glossary', () => {
  it('has a term, forms to find it by, words to avoid and a line in each language', () => {
    for (const entry of glossary)
      for (const language of languages) {
        const { term, find, never, line } = entry[language];
        expect([term, find.length > 0, never.length > 0]).toEqual([term, true, true]);
        expect(line).toMatch(/^\S.*\.$/);
      }
  });

  it('is the document that readers see: after a change, run ./dev derive', () => {
    const program =
      'const { glossaryPage, readGlossary } = await import("./lessons/glossary.mjs"); process.stdout.write(glossaryPage(readGlossary()))';
    const page = execFileSync('node', ['--input-type=module', '-e', program], {
      cwd: root,
      encoding: 'utf8',
    });
    expect(readFileSync(`${root}lessons/GLOSSARY.md`, 'utf8')).toBe(page);
  });

  it('splits a text at the first occurrence of a term only', () => {
    const first = new FirstTerms('en');
    expect(first.split('A surrounding polygon: surrounding.')).toMatchObject([
      { text: 'A ', term: null },
      { text: 'surrounding polygon', term: { term: 'surrounding polygon' } },
      { text: ': surrounding.', term: null },
    ]);
    first.forget();
    expect(first.split('surrounding')).toMatchObject([{ term: { term: 'surrounding polygon' } }]);
  });

  it('takes a name for a name, even if it looks like a term', () => {
    const first = new FirstTerms('en', (word) => word === 'window');
    expect(first.split('Window 2 lies beside window.').map(({ term }) => term?.term)).toEqual([
      'window',
      undefined,
    ]);
    expect(first.split('window').map(({ term }) => term)).toEqual([null]);
  });

  it('finds Russian terms in each case, and no term within a longer word', () => {
    const found = new FirstTerms('ru').split('В списке активных рёбер; окнище.');
    expect(found.map(({ text }) => text)).toEqual(['В ', 'списке активных рёбер', '; окнище.']);
  });
});

describe('the texts that people read', () => {
  it('are many', () => {
    expect(texts.length).toBeGreaterThan(100);
  });

  it('avoid the words that the glossary avoids', () => {
    const never = glossary.flatMap((entry) => languages.flatMap((each) => entry[each].never));
    expect(allPlaces(wordsLike(never), true)).toEqual([]);
  });

  it('start no sentence with "Of", "Who" or "That the"', () => {
    expect(allPlaces(start)).toEqual([]);
  });

  it('use none of the phrases that no native speaker writes', () => {
    expect(allPlaces(wordsLike(phrases), true)).toEqual([]);
  });

  it('would be caught: the search finds a word, a phrase and a start', () => {
    const lines = [
      'the enclosure checks failed',
      'this is told',
      'It works. Who forgets it loses.',
    ];
    const found = [wordsLike(['enclosure check*']), wordsLike(phrases), start];
    expect(found.flatMap((pattern) => places(lines, 'a.md', pattern))).toEqual([
      'a.md:1: enclosure checks',
      'a.md:2: is told',
      'a.md:3: . Who forgets',
    ]);
  });
});
