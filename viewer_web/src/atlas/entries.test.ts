import { readFileSync, readdirSync } from 'node:fs';
import { expect, it } from 'vitest';
import { entriesIn, kindOfEntry } from './entries.js';

const folder = new URL('../../../lessons/failures/', import.meta.url);
const files = readdirSync(folder)
  .filter((file) => file.endsWith('.json'))
  .map((file) => [file.replace('.json', ''), readFileSync(new URL(file, folder), 'utf8')]);
const entries = entriesIn(JSON.stringify(files));

it('tells rounding, the printed text, usual mistakes and limits of a method apart', () => {
  const kindOf = (name: string): string | undefined =>
    entries.find((entry) => entry.name === name)?.kind;
  expect(kindOf('clip-pixel')).toBe('rounding');
  expect(kindOf('x-w1')).toBe('printed');
  expect(kindOf('mistake-one-list')).toBe('mistake');
  expect(kindOf('missed-peak')).toBe('limit');
  expect(kindOf('contraction-to-fma')).toBe('test');
  expect(kindOfEntry({})).toBe('test');
});

it('has all entries, those of a kind together, each with a title in both languages', () => {
  expect(entries.length).toBe(files.length);
  const kinds = entries.map(({ kind }) => kind);
  expect(kinds.filter((kind, i) => kind !== kinds[i - 1]).length).toBe(new Set(kinds).size);
  for (const { title } of entries) expect([title.en, title.ru]).not.toContain('');
});
