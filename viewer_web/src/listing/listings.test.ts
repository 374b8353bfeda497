import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import { allSamples } from '../testing/samples.js';
import { methods } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { listingsOf, wrongLines } from './listings.js';

const detail = 'signs';

describe('the listings', () => {
  it.each(languages)('have a line for each label of an event, in %s', (language) => {
    const labels = methods.flatMap((method) =>
      listingsOf({ method, edition: 'corrected', detail }, language).flatMap(({ lines }) =>
        lines.map(({ at }) => at),
      ),
    );
    for (const event of allSamples) expect(labels).toContain(event.at);
  });

  it('show the printed text with its defects', () => {
    const lines = listingsOf({ method: 'warnock', edition: 'printed', detail }, 'en').flatMap(
      (listing) => listing.lines,
    );
    const corrected = listingsOf({ method: 'warnock', edition: 'corrected', detail }, 'en').flatMap(
      (listing) => listing.lines,
    );
    const printed = lines.filter(({ defects }) => defects.length > 0);
    expect(printed.flatMap(({ defects }) => defects)).toContain('X-W3');
    expect(corrected.flatMap(({ defects }) => defects)).toEqual([]);
    expect(lines.length).toBe(corrected.length);
  });

  it('show the lines of a single defect as they are printed, and no others', () => {
    const textOf = (edition: Header['edition'], label: string): string | undefined =>
      listingsOf({ method: 'warnock', edition, detail }, 'en')
        .flatMap(({ lines }) => lines)
        .find(({ at }) => at === label)?.text;
    expect(textOf('printed:x-w3', 'PW7')).toBe('if 0 < k < 4: hasSurround := false');
    expect(textOf('printed:x-w3', 'PW1')).toBe(textOf('corrected', 'PW1'));
    expect(textOf('printed:x-w2+x-w3', 'PW1')).toBe(textOf('printed', 'PW1'));
  });

  it('round what the printed text compares for equality, which is no defect of its own', () => {
    const linesOf = (
      edition: Header['edition'],
    ): readonly (readonly [string, readonly string[]])[] =>
      listingsOf({ method: 'zbuffer', edition, detail }, 'en')
        .flatMap(({ lines }) => lines)
        .filter(({ at }) => at === 'Z7' || at === 'Z9')
        .map(({ text, defects }) => [text, defects]);
    expect(linesOf('printed')).toEqual([
      ['if rnd yₜ = rnd ySnext:', []],
      ['for each edge of S with rnd y₁ = rnd yₜ = rnd y₂: ShowLine(yₜ, (x₁, z₁), (x₂, z₂))', []],
    ]);
    expect(linesOf('printed:x-z1')).toEqual(linesOf('corrected'));
  });

  it('show the line of a usual mistake as it is often written', () => {
    const lines = listingsOf({ method: 'warnock', edition: 'one-list', detail }, 'en').flatMap(
      (listing) => listing.lines,
    );
    const wrong = lines.filter(({ defects }) => defects.length > 0);
    expect(wrong.map(({ at, text, defects }) => [at, text, defects])).toEqual([
      ['W13', 'else: push each quarter of U that overlaps the area, with APL itself', ['≠']],
    ]);
  });

  it('belong to a method', () => {
    const names = listingsOf({ method: 'zbuffer', edition: 'corrected', detail }, 'en').map(
      ({ name }) => name,
    );
    expect(names).toEqual(['ZBuffer', 'ShowLine', 'Depth', 'InitializePolygon']);
  });
});

describe('the wrong variants of lines', () => {
  const run = { method: 'warnock', edition: 'corrected', kernel: 'double' } as const;
  const ways = (of: Parameters<typeof wrongLines>[0], label: string): readonly string[] =>
    (wrongLines(of).get(label) ?? []).map(({ edition }) => edition);

  it('are defects of the printed text and usual mistakes', () => {
    expect(ways(run, 'PW7')).toEqual(['printed:x-w3', 'surround-kept']);
    expect(ways(run, 'W13')).toEqual(['printed:x-w5', 'one-list', 'integer-division']);
    expect(ways(run, 'W5')).toEqual([]);
  });

  it('belong to the method', () => {
    expect(ways({ ...run, method: 'zbuffer' }, 'I1')).toEqual(['printed:x-w6', 'y-flipped']);
    expect(ways({ ...run, method: 'warnock-full' }, 'TF3')).toEqual(['line-for-edge']);
    expect(ways({ ...run, method: 'floating-horizon' }, 'FH1')).toEqual([
      'printed:x-h1',
      'printed:x-h3',
    ]);
    expect(wrongLines({ ...run, method: 'weiler-atherton' }).size).toBe(0);
  });

  it('run under the kernel', () => {
    expect(ways({ ...run, kernel: 'float' }, 'PW7')).toEqual(['printed:x-w3']);
    expect(wrongLines({ ...run, kernel: 'filtered' }).size).toBe(0);
  });

  it('are not offered if the run is already wrong', () => {
    expect(wrongLines({ ...run, edition: 'printed' }).size).toBe(0);
    expect(wrongLines({ ...run, edition: 'one-list' }).size).toBe(0);
  });
});
