import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { answers, everyQuestion, sorted } from '../testing/questions.js';
import type { Agrees } from '../testing/questions.js';
import { polygonsAgree } from '../testing/polygon-answers.js';
import { regionsAgree } from '../testing/region-answers.js';
import { textOf, traceNames, traceOf } from '../testing/traces.js';
import { toNumber } from '../language/words.js';
import type { Values } from '../replay/values.js';
import { hasThreeLists } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { Trace } from '../replay/trace.js';
import type { N } from '../trace/values.js';
import { corners as places } from '../trace/events.js';
import { parts as forms } from './question.js';
import type { Abouts, Kind, Question } from './question.js';

/** The lessons' traces are included if they were built. */
const folder = process.env['VIDNO_TRACES'] ?? '../build/lessons';
const lessons = existsSync(folder)
  ? readdirSync(folder).filter((name) => name.endsWith('.jsonl.gz'))
  : [];
const lesson = (name: string): Uint8Array<ArrayBuffer> =>
  new Uint8Array(gunzipSync(readFileSync(join(folder, name))));
const all = [
  ...traceNames.map((name) => [name, () => textOf(name)] as const),
  ...lessons.map((name) => [name, () => lesson(name)] as const),
];

/** The number of rows made from `n` values, none longer than the list of values. */
const rows = (n: number): number =>
  Array.from({ length: n + 1 }, (_, length) => n ** length).reduce((sum, each) => sum + each);

/** The number of possible answers. */
const possible = ({ parts }: Question): number =>
  parts.reduce((product, { asks, options: { length: n } }) => {
    const [form] = forms[asks];
    return product * { one: n, some: 2 ** n, row: rows(n), table: Infinity }[form];
  }, 1);

type About = Abouts['ray'];

/** The side of an edge on which a point lies, computed from the scene. */
function side({ vertices }: Polygon, edge: number, [x = 0, y = 0]: readonly number[]): number {
  const [x1 = 0, y1 = 0] = vertices[edge] ?? [];
  const [x2 = 0, y2 = 0] = vertices[(edge + 1) % vertices.length] ?? [];
  return (x2 - x1) * (y - y1) - (y2 - y1) * (x - x1);
}

/**
 * Whether the centre of a window that no edge meets lies in the polygon. Null if the run cannot be expected to agree,
 * because its lesson is about a usual mistake, or about numbers so large that doubles lose the deciding digits.
 */
function surrounds({ header }: Trace, { polygon: id, window }: About): boolean | null {
  const [x, y, width, height] = window;
  const polygon = header.scene.byId.get(id);
  if (polygon === undefined) throw new Error(id);
  const isFar = polygon.vertices.flat().some((value) => Math.abs(value) > 2 ** 20);
  if (header.edition !== 'corrected' || isFar) return null;
  const signs = polygon.vertices.map((_, edge) =>
    Math.sign(side(polygon, edge, [x + width / 2, y + height / 2])),
  );
  return new Set(signs.filter((sign) => sign !== 0)).size === 1;
}

/** How the state after the question's steps must agree, independent of the events that the question used. */
const agrees: Readonly<Record<Kind, Agrees>> = {
  ...polygonsAgree,
  ...regionsAgree,
  window: ({ trace, after, right }) => {
    const { warnock } = after;
    if (right['hides'] === undefined) return; // the method looks for no such polygon
    const isSummed = right['stay'] !== undefined && !hasThreeLists(trace.header.method);
    if (isSummed) expect(right['hides'][0] !== '').toBe(warnock?.hasSurround ?? false);
    expect(right['case']?.[0] === 'surrounded').toBe(right['hides'][0] !== '');
  },
  pop: ({ before, right, after }) => {
    const top = before.warnock?.stack.at(-1)?.window;
    expect(right['popped']).toEqual([top?.join(' ')]);
    expect(right['waiting']).toEqual([String(after.warnock?.stack.length)]);
    expect(after.warnock?.window).toEqual(top);
  },
  relation: ({ trace, question, right }) => {
    if (question.kind !== 'relation') return;
    // A polygon that surrounds the window or lies outside joins that list at the next step.
    const { joined } = trace.timeline.seek(question.until + 1).values.warnock ?? {};
    const [lies] = right['lies'] ?? [];
    for (const list of ['surrounding', 'outside'] as const) {
      expect(joined?.[list].at(-1)?.polygon === question.about.polygon).toBe(lies === list);
    }
  },
  ray: ({ trace, question, right }) => {
    if (question.kind !== 'ray') return;
    const isOdd = Number(right['crossings']?.[0]) % 2 === 1;
    expect(surrounds(trace, question.about) ?? isOdd).toBe(isOdd);
  },
  octants: ({ trace, question, right }) => {
    if (question.kind !== 'octants') return;
    const isRound = right['sum']?.[0] !== '0';
    expect(surrounds(trace, question.about) ?? isRound).toBe(isRound);
  },
  corners: ({ before, after, right }) => {
    const changed = places.filter(
      (place) => before.warnock?.corners?.[place] !== after.warnock?.corners?.[place],
    );
    expect(sorted(right['nearer'])).toEqual(sorted(changed));
  },
  inside: ({ trace, question, right }) => {
    if (question.kind !== 'inside') return;
    const polygon = trace.header.scene.byId.get(question.about.polygon);
    const edges = question.parts[1]?.given?.map(({ value }) => Number(value)) ?? [];
    right['signs']?.forEach((sign, i) => {
      const value = polygon ? side(polygon, edges[i] ?? 0, question.about.point.map(Number)) : NaN;
      if (Math.abs(value) > 1e-9) expect(sign).toBe(value > 0 ? '+' : '-');
    });
    const found = new Set(right['signs']?.filter((sign) => sign !== '0'));
    expect(right['inside']).toEqual([found.size > 1 ? 'no' : 'yes']);
  },
  point: ({ trace, after, right }) => {
    const { scene } = trace.header;
    const [winner = ''] = right['wins'] ?? [];
    expect(after.warnock?.color).toBe(scene.byId.get(winner)?.color ?? scene.background);
    expect(right['covers']).toContain(winner);
  },
  clip: ({ before, after, question, right }) => {
    const listOf = ({ warnock }: Values): readonly (readonly number[])[] =>
      (warnock?.clip?.vertices ?? []).map((vertex) => vertex.map(toNumber));
    const [old, left] = [listOf(before), listOf(after)];
    expect(left).toHaveLength(right['list']?.length ?? -1);
    right['list']?.forEach((value, i) => {
      if (value !== 'x') expect(left[i]).toEqual(old[Number(value) - 1]);
    });
    // An edge crosses the side if its ends lie on different sides of the line; on it, rounding may decide.
    const [x, y, width, height] = before.warnock?.window ?? [0, 0, 0, 0];
    const depths = [
      ([, at = 0]) => at - y,
      ([at = 0]) => at - x,
      ([, at = 0]) => y + height - at,
      ([at = 0]) => x + width - at,
    ] satisfies ((vertex: readonly number[]) => number)[];
    const depth = question.kind === 'clip' ? depths[question.about.side - 1] : undefined;
    const within = old.map((vertex) => Math.sign(depth?.(vertex) ?? NaN));
    old.forEach((_, i) => {
      const before = (i + old.length - 1) % old.length;
      const product = (within[before] ?? NaN) * (within[i] ?? NaN);
      const isCut = right['cut']?.includes(`${before + 1}–${i + 1}`);
      if (product !== 0) expect(isCut).toBe(product < 0);
    });
  },
  ael: ({ trace, question, before, after, right }) => {
    const was = before.zbuffer?.ael.map(({ edge }) => String(edge)) ?? [];
    const is = after.zbuffer?.ael.map(({ edge }) => String(edge)) ?? [];
    // Either of two edges with the same x may come first.
    if (right['order'] !== undefined) expect(right['order']).toEqual(is);
    expect(sorted(right['leave'])).toEqual(sorted(was.filter((edge) => !is.includes(edge))));
    expect(sorted(right['enter'])).toEqual(sorted(is.filter((edge) => !was.includes(edge))));
    const isCorrected = trace.header.edition === 'corrected';
    if (question.kind !== 'ael' || !isCorrected || right['entries'] === undefined) return;
    // Each edge meets the scanline where its line does, and ends in the row before its lower end.
    const polygon = trace.header.scene.byId.get(question.about.polygon);
    const y = toNumber(after.zbuffer?.y ?? NaN);
    is.forEach((edge, i) => {
      const ends = [0, 1].map((end) => {
        const { vertices = [] } = polygon ?? {};
        return (vertices[(Number(edge) + end) % vertices.length] ?? []).map(Number);
      });
      const [[x1 = 0, y1 = 0] = [], [x2 = 0, y2 = 0] = []] = ends;
      const [x = NaN, last = NaN] = right['entries']?.slice(2 * i, 2 * i + 2).map(Number) ?? [];
      expect(x).toBeCloseTo(x1 + ((y - y1) / (y2 - y1)) * (x2 - x1), 2);
      expect(Math.abs(last + 1 - Math.max(y1, y2))).toBeLessThanOrEqual(1);
    });
  },
  pixels: ({ trace, question, right }) => {
    if (question.kind !== 'pixels') return;
    const { area } = trace.header.scene;
    const cell = (step: number, x: string): unknown =>
      trace.timeline.seek(step).screen.z?.at(Number(x) - area.x, question.about.row - area.y);
    for (const { value } of question.parts[0]?.options ?? []) {
      const isOther = cell(question.step, value) !== cell(question.until, value);
      expect(right['shown']?.includes(value)).toBe(isOther);
    }
  },
  flags: ({ trace, question, right }) => {
    const { timeline, header } = trace;
    for (const { value } of question.parts[0]?.options ?? []) {
      const flags = timeline.valuesAt(question.until).floatingHorizon?.flags;
      const flag = flags?.[Number(value) - header.scene.area.x];
      expect(right['above']?.includes(value)).toBe(flag === 1 || flag === 2);
      expect(right['below']?.includes(value)).toBe(flag === -1 || flag === 2);
    }
  },
  horizons: ({ trace, question, right }) => {
    const { step, until, parts } = question;
    for (const { value } of parts[0]?.options ?? []) {
      const changes = (which: 'upper' | 'lower'): boolean =>
        over(trace, step, value, which) !== over(trace, until, value, which);
      expect(right['raised']?.includes(value)).toBe(changes('upper'));
      expect(right['lowered']?.includes(value)).toBe(changes('lower'));
    }
  },
  sideEdge: ({ trace, question, right }) => {
    if (question.kind !== 'sideEdge') return;
    // The height of the edge over a column, from its ends; heights grow downward.
    const [[x1 = NaN, y1 = NaN], [x2 = NaN, y2 = NaN]] = [
      question.about.from.map(toNumber),
      question.about.to.map(toNumber),
    ] as const;
    for (const { value } of question.parts[0]?.options ?? []) {
      const y = y1 + ((Number(value) - x1) / (x2 - x1)) * (y2 - y1);
      const now = (which: 'upper' | 'lower'): number =>
        toNumber(over(trace, question.step, value, which) ?? 'nan');
      expect(right['raised']?.includes(value)).toBe(!(y >= now('upper')));
      expect(right['lowered']?.includes(value)).toBe(!(y <= now('lower')));
    }
  },
  meeting: ({ trace, question, right }) => {
    // The place where the straight segment is as high as the straight horizon that it was compared with.
    const [from, to] = question.parts[1]?.options.map(({ value }) => value).filter(Number) ?? [];
    const event = trace.timeline.event(question.until);
    if (event?.e !== 'intersection' || from === undefined || to === undefined) return;
    const [x, y] = event.point.map(toNumber);
    const which = right['meets']?.[0] === 'upper' ? 'upper' : 'lower';
    const { floatingHorizon } = trace.timeline.valuesAt(question.step);
    const height = (at: number): number =>
      toNumber(floatingHorizon?.before[which][at - trace.header.scene.area.x] ?? 'nan');
    const [left, next] = event.columns;
    const part = left === next ? 0 : (x ?? NaN) - left;
    expect(height(left) + (height(next) - height(left)) * part).toBeCloseTo(y ?? NaN, 9);
  },
};

/** The horizon over a column. */
const over = (
  trace: Trace,
  step: number,
  x: string,
  which: 'upper' | 'lower',
): N | null | undefined =>
  trace.timeline.valuesAt(step).floatingHorizon?.horizons[which][
    Number(x) - trace.header.scene.area.x
  ];

describe.each(all)('every question of %s', { timeout: 60_000 }, (_name, content) => {
  it('has the answer of the later state', async () => {
    const trace = await traceOf(content());
    for (const question of everyQuestion(trace)) {
      const before = trace.timeline.seek(question.step).values;
      const after = trace.timeline.seek(question.until).values;
      agrees[question.kind]({ trace, question, before, after, right: answers(question) });
    }
  });

  it('has at least six possible answers, and is decided only after its step', async () => {
    for (const question of everyQuestion(await traceOf(content()))) {
      expect(possible(question)).toBeGreaterThanOrEqual(6);
      expect(Math.min(...question.because)).toBeGreaterThan(question.step);
      expect(Math.max(...question.because)).toBe(question.until);
    }
  });
});
