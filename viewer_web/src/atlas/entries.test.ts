import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { describe, expect, it } from 'vitest';
import { entries as entriesOf } from '../../plugins/atlas.js';
import { ExactPolygon, centreOf, ownerAt } from '../testing/exact-scene.js';
import { entriesIn, kindOfEntry } from './entries.js';
import type { Entry } from './entries.js';

const folder = fileURLToPath(new URL('../../../lessons/failures/', import.meta.url));
const files = entriesOf(folder);
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

interface Polygons {
  readonly polygons?: readonly {
    readonly id: string;
    readonly vertices: readonly (readonly (number | string)[])[];
  }[];
}
/** A coordinate, perhaps a power of two as hexadecimal text. */
function coordinate(given: number | string): number {
  if (typeof given === 'number') return given;
  const [, minus = '', power = ''] = /^(-?)0x1p(\d+)$/.exec(given) ?? [];
  return Number(`${minus}1`) * 2 ** Number(power);
}
const polygonsOf = ({ scene }: Entry): Polygons['polygons'] =>
  (scene as Polygons | undefined)?.polygons;

describe('why a picture has no proof', () => {
  const reasons = entries.flatMap((entry) =>
    entry.unproved === null ? [] : [[entry.name, entry, entry.unproved] as const],
  );
  /** The program that proves pictures; `./dev test` names it. */
  const program = process.env['VIDNO_PROGRAM'] ?? '';
  const proving = ({ name }: Entry): ReturnType<typeof spawnSync> =>
    spawnSync(program, ['prove', `${folder}${name}.json`, '-o', '-'], { encoding: 'utf8' });

  it('is said of each wrong pixel that an entry shows, and of no curve', () => {
    const polygons = entries.filter((entry) => polygonsOf(entry) !== undefined);
    const showing = polygons.filter(({ shows }) => shows?.pixel !== undefined);
    expect(showing.length).toBeGreaterThan(35);
    expect(showing.filter(({ unproved }) => unproved === null)).toEqual([]);
    expect(reasons.filter(([, entry]) => !polygons.includes(entry))).toEqual([]);
  });

  it.each(reasons)('names what shows in exact numbers: %s', (_name, entry, { en, ru }) => {
    const [, place, x, y, owner = null] =
      /^Pixel ((-?\d+),(-?\d+)): .* is painted, but (?:(\S+) shows|no polygon shows)/.exec(en) ??
      [];
    const polygons = polygonsOf(entry) ?? [];
    const exact = polygons.map(
      ({ vertices }) =>
        new ExactPolygon({ vertices: vertices.map((each) => each.map(coordinate)) }),
    );
    const shown = ownerAt(exact, centreOf(Number(x), Number(y)));
    expect(owner).toBe(shown === null ? null : polygons[shown]?.id);
    expect(ru).toMatch(
      new RegExp(
        `^Пиксель ${String(place)}: .*, но ${owner === null ? 'не виден ни один' : `${owner} виден`}`,
      ),
    );
  });

  it.skipIf(program === '')(
    'is said where the program finds no proof, of one of its pixels',
    () => {
      for (const entry of entries.filter((each) => polygonsOf(each) !== undefined)) {
        const { status, stdout } = proving(entry);
        expect([entry.name, status]).toEqual([entry.name, entry.unproved === null ? 0 : 1]);
        const pixel = entry.unproved?.en.split(':')[0]?.toLowerCase() ?? '';
        expect(String(stdout)).toContain(pixel);
      }
    },
  );
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
