import { readFileSync, readdirSync } from 'node:fs';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { expect, it } from 'vitest';
import { entriesIn, kindOfEntry } from './entries.js';

const folder = new URL('../../../lessons/failures/', import.meta.url);
const files = readdirSync(folder)
  .filter((file) => file.endsWith('.json'))
  .map((file) => [file.replace('.json', ''), readFileSync(new URL(file, folder), 'utf8')]);
const entries = entriesIn(JSON.stringify(files));

it('distinguishes rounding, the printed text, usual mistakes and limits of a method', () => {
  const kindOf = (name: string): string | undefined =>
    entries.find((entry) => entry.name === name)?.kind;
  expect(kindOf('clip-pixel')).toBe('rounding');
  expect(kindOf('x-w1')).toBe('printed');
  expect(kindOf('mistake-one-list')).toBe('mistake');
  expect(kindOf('missed-peak')).toBe('limit');
  expect(kindOf('contraction-to-fma')).toBe('test');
  expect(kindOfEntry({})).toBe('test');
});

it('has all entries, grouped by kind, each with a title in both languages', () => {
  expect(entries.length).toBe(files.length);
  const kinds = entries.map(({ kind }) => kind);
  expect(kinds.filter((kind, i) => kind !== kinds[i - 1]).length).toBe(new Set(kinds).size);
  for (const { title } of entries) expect([title.en, title.ru]).not.toContain('');
});

const schema = (name: string): object =>
  JSON.parse(
    readFileSync(new URL(`../../../trace/schema/${name}.schema.json`, import.meta.url), 'utf8'),
  ) as object;
const ajv = new Ajv2020({ strict: false });
for (const name of ['scene', 'surface', 'failure']) ajv.addSchema(schema(name));
const validate = (entry: unknown): unknown =>
  ajv.validate('failure.schema.json', entry) || ajv.errors;

it.each(files)('%s fits the schema of the repository', (_name, text = '') => {
  expect(validate(JSON.parse(text))).toBe(true);
});

const [, clipped = ''] = files.find(([name]) => name === 'clip-pixel') ?? [];
const [, peak = ''] = files.find(([name]) => name === 'missed-peak') ?? [];
const changed = (text: string, parts: object): object => ({
  ...(JSON.parse(text) as object),
  ...parts,
});
const run = { method: 'warnock', kernel: 'double', edition: 'corrected' };

it.each([
  ['an unknown key', changed(clipped, { because: 'x' })],
  ['no remedy', changed(clipped, { remedy: undefined })],
  ['one language', changed(clipped, { title: { en: 'x' } })],
  ['an unknown method', changed(clipped, { fails: { ...run, method: 'painter' } })],
  ['an unknown kernel', changed(clipped, { fails: { ...run, kernel: 'bits:3' } })],
  ['an unknown edition', changed(clipped, { holds: { ...run, edition: 'printed:x-q1' } })],
  ['nothing to be seen', changed(clipped, { shows: {} })],
  ['a procedure that there is not', changed(clipped, { shows: { wrong: 'Painter' } })],
  ['a line that there is not', changed(clipped, { shows: { fault: 'Q1' } })],
  ['a column of polygons', changed(clipped, { shows: { column: [0, 1] } })],
  ['a pixel of curves', changed(peak, { shows: { pixel: [0, 1] } })],
  ['a method of polygons for curves', changed(peak, { fails: run })],
  ['a scene and a test', changed(clipped, { test: 'x' })],
])('the schema refuses %s', (_what, entry) => {
  expect(validate(JSON.parse(JSON.stringify(entry)))).not.toBe(true);
});
