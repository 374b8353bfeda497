import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import { textOf, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { Outline } from './outline.js';
import { sayTerm, termsOf, without, written } from './query.js';
import { Search } from './search.js';

const eventsIn = (name: string): readonly Event[] =>
  textOf(`${name}.jsonl`)
    .trim()
    .split('\n')
    .slice(1, -1)
    .map((line) => JSON.parse(line) as Event);

/** The first steps of all hits. */
async function found(name: string, query: string): Promise<readonly number[]> {
  const outline = new Outline(await traceOf(textOf(`${name}.jsonl`)));
  outline.read();
  const search = new Search(outline, termsOf(query, outline.trace.header));
  for (let i = 0; !search.read(0); i++) expect(i).toBeLessThan(10_000);
  return search.hits.map((node) => outline.nodes.first[node] ?? 0);
}

/** The ranges from each event with some names up to the next, with the step of the first, computed without the outline. */
function stretches(
  name: string,
  begin: Event['e'],
): readonly (readonly [number, readonly Event[]])[] {
  const all: [number, Event[]][] = [];
  eventsIn(name).forEach((event, i) => {
    if (event.e === begin) all.push([i + 1, []]);
    all.at(-1)?.[1].push(event);
  });
  return all;
}

const warnock = 'small.warnock.signs';
const zbuffer = 'small.zbuffer.signs';

describe('a search', () => {
  it.each(['B', 'far wall', 'the "B"'])(
    'understands its own suggestion for a polygon named %s',
    async (id) => {
      const { header } = await traceOf(textOf(`${warnock}.jsonl`));
      const [polygon] = header.scene.polygons;
      if (polygon === undefined) throw new Error('a polygon');
      const named = { ...header, scene: { ...header.scene, polygons: [{ ...polygon, id }] } };
      for (const language of languages) {
        const [term, ...others] = termsOf(written('polygon', id, language), named);
        expect(term?.meanings).toEqual([{ facet: 'polygon', values: new Set([0]) }]);
        expect(others).toEqual([]);
      }
    },
  );

  it('finds the windows of a case', async () => {
    const split = stretches(warnock, 'pop').filter(([, events]) =>
      events.some((event) => event.e === 'decide' && event.case === 'split'),
    );
    const steps = split.map(([step]) => step);
    for (const query of ['case:split', 'split', 'spl', 'случай:делится', 'делится']) {
      expect([query, await found(warnock, query)]).toEqual([query, steps]);
    }
  });

  it('finds the windows in which a polygon is tested', async () => {
    const steps = stretches(warnock, 'pop')
      .filter(([, events]) => events.some((event) => 'polygon' in event && event.polygon === 'B'))
      .map(([step]) => step);
    expect(steps.length).toBeGreaterThan(1);
    for (const query of ['B', 'polygon:B', 'b', 'многоугольник:B']) {
      expect([query, await found(warnock, query)]).toEqual([query, steps]);
    }
  });

  it('finds nodes that match all terms', async () => {
    const steps = stretches(warnock, 'pop')
      .filter(
        ([, events]) =>
          events.some((event) => 'polygon' in event && event.polygon === 'B') &&
          events.some((event) => event.e === 'decide' && event.case === 'split'),
      )
      .map(([step]) => step);
    expect(await found(warnock, 'polygon:B case:split')).toEqual(steps);
    expect(await found(warnock, 'B split')).toEqual(steps);
  });

  it('finds the calls of a procedure, for a polygon, and in windows of a case', async () => {
    const calls = eventsIn(warnock).flatMap((event, i) =>
      event.e === 'call' && event.of === 'SurroundTest' ? i + 1 : [],
    );
    expect(await found(warnock, 'procedure:SurroundTest')).toEqual(calls);
    const results = eventsIn(warnock).flatMap((event) =>
      event.e === 'surround' ? event.polygon : [],
    );
    const ofB = calls.filter((_, i) => results[i] === 'B');
    expect(await found(warnock, 'procedure:surroundtest polygon:B')).toEqual(ofB);
    const splits = await found(warnock, 'split');
    const pops = stretches(warnock, 'pop').map(([step]) => step);
    const inSplits = calls.filter((call) =>
      splits.includes(pops.filter((pop) => pop < call).at(-1) ?? 0),
    );
    expect(await found(warnock, 'SurroundTest split')).toEqual(inSplits);
  });

  it('finds rows of polygons, and the lines that are shown in them', async () => {
    const rows = stretches(zbuffer, 'scanline').filter(
      ([, [begins]]) => begins?.e === 'scanline' && begins.row === 1,
    );
    expect(await found(zbuffer, 'row:1')).toEqual(rows.map(([step]) => step));
    const [ofB] = stretches(zbuffer, 'polygon').filter(
      ([, [begins]]) => begins?.e === 'polygon' && begins.polygon === 'B',
    );
    const from = ofB?.[0] ?? 0;
    expect(await found(zbuffer, 'polygon:B')).toEqual([from]);
    const until = from + (ofB?.[1].length ?? 0);
    const inB = rows.map(([step]) => step).filter((step) => step > from && step < until);
    expect(await found(zbuffer, 'polygon:B row:1')).toEqual(inB);
    const shown = eventsIn(zbuffer).flatMap((event, i) =>
      event.e === 'call' && i + 1 > from && i + 1 < until ? i + 1 : [],
    );
    expect(await found(zbuffer, 'B ShowLine')).toEqual(shown);
  });

  it('finds lists that contain a polygon, and curves by their number', async () => {
    const regions = 'wedge.weiler-atherton.polygons';
    const id = eventsIn(regions).find((event) => event.e === 'pop_list')?.clip ?? '';
    const lists = stretches(regions, 'pop_list')
      .map(([step, events]) => {
        const end = events.findIndex((event) => event.at === 'WA10');
        return [step, end < 0 ? events : events.slice(0, end)] as const;
      })
      .filter(
        ([, [begins, ...others]]) =>
          (begins?.e === 'pop_list' && begins.clip === id) ||
          others.some((event) => 'polygon' in event && event.polygon === id),
      );
    expect(await found(regions, `polygon:${id}`)).toEqual(lists.map(([step]) => step));
    const curves = 'hills.floating-horizon.signs';
    const second = stretches(curves, 'curve')[1]?.[0];
    expect(await found(curves, 'curve:1')).toEqual([second]);
    expect(await found(curves, '1')).toEqual([second]);
  });

  it('finds nothing if a term has no meaning', async () => {
    expect(await found(warnock, 'polygon:nobody')).toEqual([]);
    expect(await found(warnock, 'split nobody')).toEqual([]);
    expect(await found(warnock, 'curve:1')).toEqual([]);
    expect(await found(warnock, '')).toEqual([]);
  });
});

describe('a query', () => {
  it('has terms that are explained in words, and can be removed', async () => {
    const { header } = await traceOf(textOf(`${warnock}.jsonl`));
    const terms = termsOf('polygon:B  spl "no one"', header);
    expect(terms.map(({ word }) => word)).toEqual(['polygon:B', 'spl', '"no one"']);
    expect(terms.map((term) => sayTerm(term, header, 'en'))).toEqual([
      'polygon B',
      'case split',
      '',
    ]);
    expect(terms.map((term) => sayTerm(term, header, 'ru'))).toEqual([
      'многоугольник B',
      'случай делится',
      '',
    ]);
    const [first] = terms;
    if (first === undefined) throw new Error('no term');
    expect(without(terms, first)).toBe('spl "no one"');
  });

  it('takes a word as a prefix', async () => {
    const { header } = await traceOf(textOf(`${warnock}.jsonl`));
    const [term] = termsOf('surr', header);
    if (term === undefined) throw new Error('no term');
    expect(sayTerm(term, header, 'en')).toBe('case surrounded / procedure SurroundTest');
  });
});
