import { describe, expect, it } from 'vitest';
import { linesOf, textOf, traceNames, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import type { Trace } from '../replay/trace.js';
import { Outline, sayNode } from './outline.js';
import { none } from './table.js';

async function outlineIn(name: string): Promise<Outline> {
  const outline = new Outline(await traceOf(textOf(`${name}.jsonl`)));
  outline.read();
  return outline;
}

/** The events of a file, each at its step. */
const eventsIn = (name: string): readonly (readonly [step: number, event: Event])[] =>
  textOf(`${name}.jsonl`)
    .trim()
    .split('\n')
    .slice(1, -1)
    .map((line, i) => [i + 1, JSON.parse(line) as Event]);

const nodesOf = ({ size }: Outline): readonly number[] => Array.from({ length: size }, (_, i) => i);
const itemsOf = (outline: Outline): readonly number[] =>
  nodesOf(outline).filter((node) => outline.isItem(node));
const firstOf = ({ nodes }: Outline, node: number): number => nodes.first[node] ?? 0;

/** The number of times that each word occurs. */
function tally(words: readonly string[]): Readonly<Record<string, number>> {
  const counts: Record<string, number> = {};
  for (const word of words) counts[word] = (counts[word] ?? 0) + 1;
  return counts;
}

/** The outline as indented lines, without the nodes of calls. */
const drawn = (outline: Outline): readonly string[] =>
  nodesOf(outline)
    .filter((node) => outline.isItem(node) || outline.isPart(node))
    .map(
      (node) => '  '.repeat((outline.nodes.depth[node] ?? 1) - 1) + sayNode(outline, node, 'en'),
    );

/** The procedures that are called but have no result yet at a step, by the state of the replay. */
const callsAt = ({ timeline }: Trace, step: number): readonly string[] =>
  timeline
    .seek(step)
    .values.calls.slice(1)
    .map(({ of }) => of);

/** The same by the outline. */
function callsIn(outline: Outline, step: number): readonly string[] {
  const called = [...outline.wayUp(outline.before(step))].filter(
    (node) =>
      !outline.isItem(node) &&
      !outline.isPart(node) &&
      firstOf(outline, node) <= step &&
      step < outline.lastOf(node),
  );
  return called.reverse().map((node) => outline.kindOf(node));
}

describe.each(traceNames.map((name) => name.replace('.jsonl', '')))('the outline of %s', (name) => {
  it('has the calls of the state at each step', async () => {
    const outline = await outlineIn(name);
    const { trace } = outline;
    for (let step = 0; step <= trace.timeline.length; step++) {
      expect([step, callsIn(outline, step)]).toEqual([step, callsAt(trace, step)]);
    }
  });

  it('is a tree with correct steps and places', async () => {
    const outline = await outlineIn(name);
    const { parent, place, children, depth } = outline.nodes;
    const counts = new Map<number, number>();
    for (const node of nodesOf(outline)) {
      const around = parent[node] ?? none;
      const among = (counts.get(around) ?? 0) + 1;
      counts.set(around, among);
      expect(place[node]).toBe(among);
      if (around === none) {
        expect(depth[node]).toBe(1);
        continue;
      }
      expect(depth[node]).toBe((depth[around] ?? 0) + 1);
      expect(firstOf(outline, node)).toBeGreaterThanOrEqual(firstOf(outline, around));
      expect(outline.lastOf(node)).toBeLessThanOrEqual(outline.lastOf(around));
      expect(outline.endOf(node)).toBeLessThanOrEqual(outline.endOf(around));
    }
    for (const node of nodesOf(outline)) expect(children[node]).toBe(counts.get(node) ?? 0);
    expect(outline.topSize).toBe(counts.get(none) ?? 0);
  });

  it('has a text for each result, in both languages', async () => {
    const outline = await outlineIn(name);
    for (const node of nodesOf(outline)) {
      for (const language of ['en', 'ru'] as const) {
        const said = sayNode(outline, node, language);
        expect(said).toMatch(/^\p{L}.*\S$/u);
        expect(said).not.toMatch(/undefined|null|NaN|\[object|\s\s/u);
      }
    }
  });

  it('is the same when it is read in parts', async () => {
    const whole = await outlineIn(name);
    const inParts = new Outline(whole.trace);
    for (let i = 0; !inParts.read(0); i++) expect(i).toBeLessThan(1000);
    expect(drawn(inParts)).toEqual(drawn(whole));
  });
});

describe("the windows of Warnock's algorithm", () => {
  const warnocks = traceNames
    .filter((name) => name.includes('warnock'))
    .map((name) => name.replace('.jsonl', ''));

  it.each(warnocks)('are as many of each case as the trace decides (%s)', async (name) => {
    const outline = await outlineIn(name);
    const events = eventsIn(name);
    const decided = events.flatMap(([, event]) => (event.e === 'decide' ? event.case : []));
    const listed = itemsOf(outline).map(
      (node) => /: (\w+)/.exec(sayNode(outline, node, 'en'))?.[1] ?? '',
    );
    expect(tally(listed)).toEqual(tally(decided));
  });

  it.each(warnocks)('are each in the window that was divided (%s)', async (name) => {
    const outline = await outlineIn(name);
    const windows = new Map(
      eventsIn(name).flatMap(([step, event]) => (event.e === 'pop' ? [[step, event.window]] : [])),
    );
    for (const node of itemsOf(outline)) {
      const [x, y, width, height] = windows.get(firstOf(outline, node)) ?? [0, 0, 0, 0];
      // The smallest of all earlier windows that contains it.
      const around = [...windows].filter(
        ([step, [left, top, wide, tall]]) =>
          step < firstOf(outline, node) &&
          left <= x &&
          top <= y &&
          x + width <= left + wide &&
          y + height <= top + tall,
      );
      const smallest = around.sort(([, a], [, b]) => a[2] * a[3] - b[2] * b[3])[0]?.[0];
      const parent = outline.nodes.parent[node] ?? none;
      expect(parent === none ? undefined : firstOf(outline, parent)).toBe(smallest);
    }
  });

  it('name the visible polygon, if the trace does', async () => {
    const outline = await outlineIn('inside.warnock.signs');
    // The polygon of the only window is drawn at its last event.
    expect(itemsOf(outline).map((node) => sayNode(outline, node, 'en'))).toEqual([
      'window 4 × 4 at (0, 0): single, A',
    ]);
  });
});

describe('the polygons and rows of the Z-buffer algorithm', () => {
  it.each(['small.zbuffer.windows', 'small.zbuffer.polygons', 'small.zbuffer.signs'])(
    'are those that are scanned (%s)',
    async (name) => {
      const polygons: { id: string; rows: number[] }[] = [];
      for (const [, event] of eventsIn(name)) {
        if (event.e === 'polygon') polygons.push({ id: event.polygon, rows: [] });
        else if (event.e === 'scanline') polygons.at(-1)?.rows.push(event.row);
      }
      const expected = polygons.flatMap(({ id, rows }) => [
        `polygon ${id}: rows ${rows[0]} to ${rows.at(-1)}`.replaceAll('-', '−'),
        ...rows.map((row) => `  row ${row}`.replace('-', '−')),
      ]);
      const said = drawn(await outlineIn(name));
      expect(said.map((line) => (line.startsWith('  ') ? line.replace(/:.*/, '') : line))).toEqual(
        expected,
      );
    },
  );

  it('have in each row the active edges when it is shown, and a span for each pair', async () => {
    const outline = await outlineIn('small.zbuffer.signs');
    const { timeline } = outline.trace;
    for (const node of nodesOf(outline).filter((each) => outline.isPart(each))) {
      const [first, last] = [firstOf(outline, node), outline.lastOf(node)];
      const steps = Array.from({ length: last - first + 1 }, (_, i) => first + i);
      const shows = steps.filter((step) => timeline.event(step)?.at === 'Z14');
      const spans = steps.filter((step) => timeline.event(step)?.e === 'span').length;
      const at = shows.at(0) ?? last;
      const edges = timeline.seek(at).values.zbuffer?.ael.length ?? -1;
      expect(sayNode(outline, node, 'en')).toMatch(
        new RegExp(`: ${edges} edges?, ${spans} spans?$`),
      );
    }
  });
});

describe("the lists of Weiler and Atherton's algorithm", () => {
  const name = 'wedge.weiler-atherton.polygons';

  it('are those popped from the stack, each with its clip polygon', async () => {
    const popped = eventsIn(name).flatMap(([, event]) =>
      event.e === 'pop_list'
        ? `list of ${event.count} ${event.count === 1 ? 'piece' : 'pieces'}, clip polygon ${event.clip}`
        : [],
    );
    const said = drawn(await outlineIn(name)).map((line) => line.trim().replace(/:.*/, ''));
    expect(said).toEqual(popped);
  });

  it('are nested below a list whose inside parts are tried again, with the parts left outside', async () => {
    // By hand from the file: W is behind Q, so Q and W are put back at WA9. The part of W outside waits on the stack.
    expect(drawn(await outlineIn('wall.weiler-atherton.signs'))).toEqual([
      'list of 3 pieces, clip polygon W: behind Q',
      '  list of 2 pieces, clip polygon Q: visible',
      '  list of 1 piece, clip polygon W: visible',
      'list of 2 pieces, clip polygon Q: visible',
      'list of 1 piece, clip polygon S: visible',
    ]);
  });

  it('are visible once for each region shown', async () => {
    const shown = eventsIn(name).filter(([, event]) => event.e === 'show').length;
    expect(drawn(await outlineIn(name)).filter((line) => line.endsWith(': visible'))).toHaveLength(
      shown,
    );
  });

  it('do not include painting, which is not part of a list', async () => {
    const outline = await outlineIn(name);
    const last = outline.before(outline.trace.timeline.length);
    const way = [...outline.wayUp(last)];
    expect(way.map((node) => outline.kindOf(node))).toEqual(['PaintRegions']);
  });
});

describe('the curves of the floating horizon', () => {
  it.each(['hills.floating-horizon.windows', 'hills.floating-horizon.signs'])(
    'have as many visible lines as are drawn (%s)',
    async (name) => {
      const lines: number[] = [];
      for (const [, event] of eventsIn(name)) {
        if (event.e === 'curve') lines.push(0);
        else if (event.e === 'draw_line') lines.push((lines.pop() ?? 0) + 1);
      }
      const expected = lines.map((n, i) => {
        const seen = n === 0 ? 'hidden' : n === 1 ? '1 visible line' : `${n} visible lines`;
        return `curve ${i}: ${seen}`;
      });
      expect(drawn(await outlineIn(name))).toEqual(expected);
    },
  );
});

describe('an outline', () => {
  it('grows with its trace', async () => {
    const [header = '', ...lines] = textOf('small.warnock.signs.jsonl').split('\n');
    const part = await traceOf([header, ...lines.slice(0, 40), ''].join('\n'));
    const outline = new Outline(part);
    outline.read();
    expect(outline.isUpToDate).toBe(true);
    const end = outline.lastOf(0);
    expect(end).toBe(40); // the first window is open
    expect(outline.at(40)).not.toBe(none);
  });

  it('has no node before the first item, and none for a run without events', async () => {
    const outline = await outlineIn('small.zbuffer.signs');
    expect(outline.at(0)).toBe(none);
    const empty = new Outline(
      await traceOf(linesOf(JSON.parse(textOf('small.zbuffer.signs.jsonl').split('\n')[0] ?? ''))),
    );
    expect(empty.read()).toBe(true);
    expect(empty.size).toBe(0);
  });
});
