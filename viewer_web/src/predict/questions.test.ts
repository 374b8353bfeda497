import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { answers, questionFrom } from '../testing/questions.js';
import { headerOf, textOf, textWith, traceOf, pop, push } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import type { Trace } from '../replay/trace.js';
import { excerpt } from '../listing/listings.js';
import { kinds, proceduresOf } from './question.js';
import type { Option, Question } from './question.js';
import { kindsOf, nextQuestion } from './questions.js';

/**
 * A is the square from (1, -2) to (8, 4) with z = 1/10. B is the triangle (2.5, -0.5, 0.3), (6, 0, 0.4), (4, 2.5, 0.2). The
 * plane of B is z = (0.7 x - y + 3.6) / 19.5: at its vertices 5.85, 7.8 and 3.9 over 19.5.
 */
const small = (run: string): Promise<Trace> => traceOf(textOf(`small.${run}.jsonl`));

describe('Warnock’s algorithm asks', () => {
  it('which polygons of a window stay, which hides the others, and which case it is', async () => {
    // The first window is (2, -1) 8 x 8. Both polygons meet it, neither surrounds it (it extends down to y = 7), and it is
    // larger than a pixel.
    const trace = await small('warnock.signs');
    const first = questionFrom(trace, 1, 'window');
    expect(first.step).toBe(4);
    expect(first.about.window).toEqual([2, -1, 8, 8]);
    expect(answers(first)).toEqual({ stay: ['A', 'B'], hides: [''], case: ['split'] });
    // The pixel (4, 0) lies in B, and z is at least (2.8 - 1 + 3.6) / 19.5 = 0.277 there, so B hides A.
    const hidden = questionFrom(trace, 1140, 'window');
    expect(hidden.about.window).toEqual([4, 0, 1, 1]);
    expect(answers(hidden)).toEqual({ stay: ['A', 'B'], hides: ['B'], case: ['surrounded'] });
  });

  it('which hides the others, beside the depths of the planes at the corners', async () => {
    // A lies at 0.1. z of B at (2, -1), (10, -1), (2, 7), (10, 7) is (6, 11.6, -2, 3.6) / 19.5.
    const { parts } = questionFrom(await small('warnock.signs'), 1, 'window');
    const [a, b, none] = parts.find(({ asks }) => asks === 'hides')?.options ?? [];
    const numbersOf = (option: Option | undefined): readonly number[] =>
      (option?.note?.(texts.en) ?? '')
        .replaceAll('−', '-')
        .replaceAll('≈', '')
        .split('; ')
        .map(Number);
    expect(numbersOf(a)).toEqual([0.1, 0.1, 0.1, 0.1]);
    [6, 11.6, -2, 3.6].forEach((z, i) => expect(numbersOf(b)[i]).toBeCloseTo(z / 19.5, 3));
    expect(none?.note).toBeUndefined();
  });

  it('which polygons stay in a window, with the step at which one leaves', async () => {
    const events: readonly Event[] = [
      push,
      pop,
      { e: 'call', at: 'W6', of: 'ProcessWindow' },
      { e: 'corners', at: 'PW1', z: '-inf' },
      { e: 'discard', at: 'PW3', polygon: 'A' },
      { e: 'count', at: 'PW4', polygon: 'B', count: 1 },
      { e: 'summary', at: 'W6', count: 1, hasSurround: false, insider: true },
      { e: 'decide', at: 'W10', case: 'single' },
    ];
    const trace = await traceOf(textWith(headerOf('warnock'), events));
    const question = questionFrom(trace, 1, 'window');
    expect(answers(question)).toEqual({ stay: ['B'], hides: [''], case: ['single'] });
    expect(question.because).toEqual([5, 7, 8]);
  });

  it('which window is popped next, and how many wait after it', async () => {
    // The window (2, -1) 8 x 8 is split. Its lower parts begin at y = 3, below the area, and are skipped. The upper right
    // part is pushed last, and the upper left one waits.
    const question = questionFrom(await small('warnock.signs'), 1, 'pop');
    expect(question.about.divided).toEqual([2, -1, 8, 8]);
    expect(question.parts[0]?.options.map(({ value }) => value)).toEqual(['2 -1 4 4', '6 -1 4 4']);
    expect(answers(question)).toEqual({ popped: ['6 -1 4 4'], waiting: ['1'] });
  });

  it('nothing about the polygons if the trace is too coarse', async () => {
    const question = questionFrom(await small('warnock.windows'), 1, 'window');
    expect(answers(question)).toEqual({ hides: [''], case: ['split'] });
  });

  it('at which corners a polygon is nearer', async () => {
    // z of B at (2, -1), (2, 7), (10, -1), (10, 7) is (6, -2, 11.6, 3.6) / 19.5, compared with 0.1 of A.
    const question = questionFrom(await small('warnock.signs'), 5, 'corners');
    expect(question.step).toBe(37);
    expect(answers(question)).toEqual({ nearer: ['lb', 'rb', 'rt'], cornerDepths: ['<'] });
    expect(question.things).toEqual(['polygon B', 'corner lt']);
  });

  it('which signs put a corner inside or outside', async () => {
    // (2, -1) and B: edge 2, (4, 2.5) to (2.5, -0.5): -1.5 * -3.5 - -3 * -2 = -0.75;
    // edge 0, (2.5, -0.5) to (6, 0): 3.5 * -0.5 - 0.5 * -0.5 = -1.5; edge 1, (6, 0) to (4, 2.5): -2 * -1 - 2.5 * -4 = 12.
    const question = questionFrom(await small('warnock.signs'), 40, 'inside');
    expect(question.about).toEqual({ polygon: 'B', point: [2, -1], corner: 'lb' });
    expect(answers(question)).toEqual({ inside: ['no'], signs: ['-', '-', '+'] });
  });

  it('which vertices remain after clipping by a side', async () => {
    // (1, -2), (5, 2), (0.5, 3) and the side y = 0: the edge from the last vertex to the first crosses it, the first lies
    // above it, the edge to the second crosses it, the second and the third lie below it.
    const question = questionFrom(await traceOf(textOf('clipped.warnock.signs.jsonl')), 1, 'clip');
    expect(question.about).toEqual({ polygon: 'A', side: 1 });
    expect(answers(question)).toEqual({ cut: ['3–1', '1–2'], list: ['x', 'x', '2', '3'] });
  });

  it('what is visible at a point, and at which depth', async () => {
    // (4.5, 1.5) lies in both; z of B is (3.15 - 1.5 + 3.6) / 19.5 = 0.2692….
    const { parts, about } = questionFrom(await small('warnock.signs'), 700, 'point');
    expect(about.point).toEqual([4.5, 1.5]);
    expect(parts.map(({ right }) => right).slice(0, 2)).toEqual([['A', 'B'], ['B']]);
    expect(Number(parts[2]?.right[0])).toBeCloseTo(5.25 / 19.5, 12);
    expect(parts[2]?.options.map(({ note }) => note?.(texts.en))).toEqual(['0.1', '≈0.2692']);
  });
});

describe('procedures that compute a number ask', () => {
  it('for the plane of a polygon', async () => {
    // B: (3.5, 0.5, 0.1) x (1.5, 3, -0.1) = (-0.35, 0.5, 9.75), and d = 0.35 * 2.5 + 0.5 * 0.5 - 9.75 * 0.3.
    const question = questionFrom(await small('warnock.signs'), 1, 'plane');
    expect(question.about).toEqual({ polygon: 'B', c: 9.75 });
    const [a, b, d] = answers(question)['plane']?.map(Number) ?? [];
    expect([a, b]).toEqual([expect.closeTo(-0.35, 9), 0.5]);
    expect(d).toBeCloseTo(-1.8, 9);
  });

  it('for the depth at a corner of the window', async () => {
    // The first corner of the window (2, -1) 8 x 8: (1.4 + 1 + 3.6) / 19.5. A is level and is not asked about.
    const question = questionFrom(await small('warnock.signs'), 1, 'depth');
    expect(question.about).toMatchObject({ polygon: 'B', point: [2, -1] });
    expect(Number(answers(question)['z']?.[0])).toBeCloseTo(6 / 19.5, 12);
  });

  it('for the pixels of a row of a clipped outline', async () => {
    // The clipped outline has the row y = 1.5 from x = 0.65 on its left edge to x = 4: of the area's columns 1 to 3, all.
    const question = questionFrom(await traceOf(textOf('clipped.warnock.signs.jsonl')), 1, 'fill');
    expect(question.about).toMatchObject({ polygon: 'A', row: 1 });
    expect(answers(question)).toEqual({ covered: ['1', '2', '3'] });
  });

  it('for the boundaries next to a vertex', async () => {
    // (2.5, -0.5) lies halfway between boundaries: 2 and -1 are sides of the window, which is not split there.
    const question = questionFrom(await small('warnock-vertex.signs'), 1, 'split');
    expect(question.about).toEqual({ polygon: 'B', vertex: 0, window: [2, -1, 5, 4] });
    expect(answers(question)).toEqual({ boundaries: ['2', '-1'], splits: ['no'] });
  });

  it('for the first edge that meets a window', async () => {
    // Edge 0 of A lies on y = -2, above the window (2, -1) 8 x 8; edge 1, on x = 8, divides it.
    const question = questionFrom(await small('warnock-full.signs'), 1, 'trial');
    expect(question.about).toEqual({ polygon: 'A', edge: 0, window: [2, -1, 8, 8] });
    expect(answers(question)).toEqual({ cornerSigns: ['+', '+', '+', '+'], meetsFirst: ['1'] });
  });

  it('for the depth of an edge-on polygon', async () => {
    // B lies on the line from (3, 0) to (5, 2). At x = 4.5, three quarters of the way, its edge from z = 0.3 to 0.4 is at 0.375, and
    // that from 0.2 to 0.3 at 0.225. Its third edge is parallel to z, at the end (5, 2).
    const trace = await traceOf(textOf('edges.warnock-edges.signs.jsonl'));
    const question = questionFrom(trace, 1, 'edgeDepth');
    expect(question.about).toEqual({ polygon: 'B', point: [4.5, 1.5] });
    expect(answers(question)).toEqual({ spanning: ['0', '2'], z: ['0.375'] });
  });

  it('for the faces that look away', async () => {
    // A tetrahedron: A, B and C share the apex at z = 1/2, and D is the base behind it, at z = -1/2.
    const question = questionFrom(
      await traceOf(textOf('body.warnock-bodies.signs.jsonl')),
      1,
      'facing',
    );
    expect(question.parts[0]?.options.map(({ value }) => value)).toEqual(['A', 'B', 'C', 'D']);
    expect(answers(question)).toEqual({ away: ['D'] });
  });
});

describe('the Z-buffer asks', () => {
  it('for the list of active edges on the first scanline', async () => {
    // Row -1 has its centre at y = -0.5, where B begins at x = 2.5: edge 2 moves right by 1.5 / 3 per row, edge 0 by 3.5 / 0.5.
    // Both begin at the same place, so that either order is right and none is asked for.
    const question = questionFrom(await small('zbuffer.signs'), 65, 'ael');
    expect(question.about).toEqual({ polygon: 'B', row: null });
    expect(answers(question)).toEqual({ enter: ['0', '2'] });
  });

  it('and on the next one, with the edges that leave and enter', async () => {
    // Edge 0 ends at y = 0, before the centre 0.5; there edge 1 has begun: x = 6 - 2 * 0.5 / 2.5 = 5.6; edge 2: x = 3. Both end
    // at (4, 2.5), the lowest point, which is on the centre line of row 2.
    const question = questionFrom(await small('zbuffer.signs'), 72, 'ael');
    expect(question.about).toEqual({ polygon: 'B', row: -1 });
    expect(answers(question)).toEqual({
      leave: ['0'],
      enter: ['1'],
      order: ['2', '1'],
      entries: ['3', '2', '5.6', '2'],
    });
  });

  it('at which pixels of a row a polygon is visible', async () => {
    // Row 0 of B, columns 3 to 5: z is (0.7 x - 0.5 + 3.6) / 19.5 at the centres, above 0.28. A has stored 0.1.
    const question = questionFrom(await small('zbuffer.signs'), 85, 'pixels');
    expect(question.about).toEqual({ polygon: 'B', row: 0 });
    expect(answers(question)).toEqual({ shown: ['3', '4', '5'], pixelDepths: ['>'] });
  });
});

const pixel = (x: number, z: number, shown: boolean): Event => ({
  e: 'pixel',
  at: 'L6',
  x,
  y: 1,
  z,
  stored: 0.5,
  shown,
});

/** A row in which A passes the stored depth, with an extra event after its pixels. */
const row = (...events: readonly Event[]): Promise<Trace> =>
  traceOf(
    textWith(headerOf('zbuffer'), [
      { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' },
      { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
      { e: 'call', at: 'Z14', of: 'ShowLine' },
      { e: 'line', at: 'L1', row: 1, from: [2, 0.4], to: [5, 0.6] },
      { e: 'columns', at: 'L4', first: 2, end: 5, z: 0.4 },
      pixel(2, 0.4, false),
      pixel(3, 0.5, false),
      pixel(4, 0.6, true),
      ...events,
      { e: 'span', at: 'Z14', row: 1, runs: [[4, 5]], depths: [0.6] },
    ]),
  );

describe('a row of pixels', () => {
  it('is the subject of a question if depths are equal, and the first polygon stays', async () => {
    const question = questionFrom(await row(), 1, 'pixels');
    expect(answers(question)).toEqual({ shown: ['4'], pixelDepths: ['='] });
    expect(question.things).toEqual(['pixel 3 1']);
  });

  const wrong: Event = {
    e: 'disagree',
    at: 'L6',
    of: 'nearer',
    taken: true,
    exact: false,
    cause: 'rounded',
  };
  const fault: Event = { e: 'fault', at: 'L6', reason: 'outside the area', x: 5, y: 1 };

  it.each([
    ['a check says that the run errs', wrong],
    ['the run fails', fault],
  ])('is not the subject of a question if %s', async (_name, event) => {
    expect(nextQuestion(await row(event), 1, new Set(kinds), [])).toBeNull();
  });
});

describe('the next question', () => {
  it('is one that the trace can answer', async () => {
    expect(kindsOf((await small('warnock.windows')).header)).toEqual(['window', 'pop']);
    expect(kindsOf((await small('warnock.polygons')).header)).not.toContain('inside');
    expect(kindsOf((await small('zbuffer.signs')).header)).toEqual(['plane', 'ael', 'pixels']);
    const wedge = await traceOf(textOf('wedge.weiler-atherton.polygons.jsonl'));
    expect(kindsOf(wedge.header)).toEqual([
      'plane',
      'piercing',
      'sort',
      'parted',
      'behind',
      'stack',
    ]);
    expect(kindsOf((await small('zbuffer.windows')).header)).toEqual([]);
  });

  it('is not always of the same kind', async () => {
    const trace = await small('warnock.signs');
    const asked: Question[] = [];
    for (let from = 1; ; from = asked.at(-1)?.until ?? 1) {
      const next = nextQuestion(trace, from, new Set(kinds), asked);
      if (next === null) break;
      asked.push(next);
    }
    const first = asked.slice(0, 4).map(({ kind }) => kind);
    expect(new Set(first).size).toBeGreaterThanOrEqual(3);
    const ofWindows = asked.filter(({ kind }) => kind === 'window' || kind === 'pop'); // one subject
    const steps = ofWindows.map(({ step }) => step);
    const gaps = steps.slice(1).map((step, i) => step - (steps[i] ?? 0));
    expect(gaps.at(-1)).toBeGreaterThan(3 * (gaps[0] ?? 0));
    expect(asked.length).toBeLessThan(40);
  });

  it('is about procedures that the listings have', () => {
    for (const name of Object.values(proceduresOf).flat()) {
      expect(excerpt([name], 'corrected', 'en').map((each) => each.name)).toEqual([name]);
    }
  });

  it('has one of the chosen kinds', async () => {
    const trace = await small('warnock.signs');
    expect(nextQuestion(trace, 1, new Set(), [])).toBeNull();
    expect(nextQuestion(trace, 1, new Set(['point']), [])?.kind).toBe('point');
  });
});
