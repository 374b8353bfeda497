import { describe, expect, it } from 'vitest';
import { correctedPixel, isCorrected } from '../language/stated.js';
import { short, toNumber } from '../language/words.js';
import { ExactCurves } from '../testing/exact-curves.js';
import type { Curve } from '../testing/exact-curves.js';
import { ExactPolygon, centreOf, ownerAt } from '../testing/exact-scene.js';
import type { Place } from '../testing/exact-scene.js';
import { make } from '../testing/made.js';
import { randomRuns } from '../testing/random-runs.js';
import type { RandomRun } from '../testing/random-runs.js';
import { Rational } from '../testing/rational.js';
import { traceOf } from '../testing/traces.js';
import type { Event, EventName } from '../trace/events.js';
import type { N } from '../trace/values.js';

/** The program that makes the runs; `./dev test` names it. */
const program = process.env['VIDNO_PROGRAM'];
/** How many runs; 2,000 take five minutes. */
const count = Number(process.env['VIDNO_RUNS'] ?? 150);

interface SceneFile {
  readonly background: string;
  readonly polygons: readonly {
    readonly id: string;
    readonly color: string;
    readonly vertices: readonly (readonly number[])[];
  }[];
}

interface SurfaceFile {
  readonly curves: readonly Curve[];
}

/** Whether what an event states is so, for the events that this test decides; null if it does not decide this one. */
type Claims = { readonly [K in EventName]?: (event: Event<K>) => boolean | null };
const claimed = (claims: Claims, event: Event): boolean | null =>
  (claims[event.e] as ((event: Event) => boolean | null) | undefined)?.(event) ?? null;

/** What is so in a scene, computed from the scene file alone. */
class Truth {
  private readonly polygons: readonly ExactPolygon[];
  /** The polygon that the Z-buffer draws. */
  private drawn = '';

  constructor(private readonly scene: SceneFile) {
    this.polygons = scene.polygons.map((each) => new ExactPolygon(each));
  }

  private placeOf = (id: string): number => this.scene.polygons.findIndex((each) => each.id === id);
  private polygon(id: string): ExactPolygon {
    const found = this.polygons[this.placeOf(id)];
    if (found === undefined) throw new Error(id);
    return found;
  }
  private place = ([x = 0, y = 0]: readonly N[]): Place => [Rational.of(x), Rational.of(y)];
  private ownerAt = (at: Place): SceneFile['polygons'][number] | undefined =>
    this.scene.polygons[ownerAt(this.polygons, at) ?? -1];
  private colorAt = (at: Place): string => this.ownerAt(at)?.color ?? this.scene.background;
  private paints = (color: string, pixels: readonly (readonly [x: number, y: number])[]): boolean =>
    pixels.every(([x, y]) => this.colorAt(centreOf(x, y)) === color);

  private readonly claims: Claims = {
    polygon: ({ polygon }) => {
      this.drawn = polygon;
      return true;
    },
    depth: ({ polygon, point, z }) => {
      const own = this.polygon(polygon);
      return own.isEdgeOn ? null : looksLike(z, own.depth(this.place(point)));
    },
    orient: (event) => {
      const cross = this.polygon(event.polygon).cross(event.edge, this.place(event.point));
      return cross.sign === event.sign && looksLike(event.value, cross);
    },
    surround: ({ polygon, point, inside }) =>
      this.polygon(polygon).holds(this.place(point)) === inside,
    pixel: ({ x, y, z, shown }) => {
      const [at, own] = [centreOf(x, y), this.polygon(this.drawn)];
      if (!own.holds(at)) return false;
      const place = this.placeOf(this.drawn);
      const soFar = this.polygons.slice(0, place + 1);
      return (ownerAt(soFar, at) === place) === shown && looksLike(z, own.depth(at));
    },
    color: ({ point, color }) => this.colorAt(this.place(point)) === color,
    fill: ({ at, rect: [left, top, width, height], color }) => {
      // The only polygon is drawn over it.
      if (at === 'W10' || at === 'WF6') return null;
      const rows = Array.from({ length: height }, (_, i) => asRun([top + i, left, left + width]));
      return this.paints(color, rows.flatMap(pixelsOf));
    },
    paint: ({ polygon, runs }) =>
      this.paints(
        this.scene.polygons[this.placeOf(polygon)]?.color ?? '',
        runs.map(asRun).flatMap(pixelsOf),
      ),
  };

  isSo = (event: Event): boolean | null => claimed(this.claims, event);

  /** Whether what is said to be so at a pixel is. */
  isSaidRightly(said: string): boolean {
    const [, x, y, rest] = /pixel \((\S+), (\S+)\) shows (.+)\.$/u.exec(said) ?? [];
    if (x === undefined || y === undefined || rest === undefined) return true;
    const at = centreOf(numberIn(x), numberIn(y));
    const owner = this.ownerAt(at);
    if (owner === undefined) return rest === 'the background';
    return rest.startsWith(`${owner.id}, whose depth there is `);
  }
}

/** What is so of curves, computed from the surface file alone. */
class TruthOfCurves {
  private readonly curves: ExactCurves;
  private drawn = 0;

  constructor({ curves }: SurfaceFile) {
    this.curves = new ExactCurves(curves);
  }

  /** A point over a column, or where the curve meets a horizon between two. */
  private isEnd([x = 0, y = 0]: readonly N[], [left, right]: readonly [number, number]): boolean {
    if (left === right) return looksLike(y, this.curves.height(this.drawn, left) ?? zero);
    return this.curves
      .crossings(this.drawn, left)
      .some(([atX, atY]) => looksLike(x, atX) && looksLike(y, atY));
  }

  private readonly claims: Claims = {
    curve: ({ curve }) => {
      this.drawn = curve;
      return null;
    },
    height: ({ x, y, upper, lower }) => {
      const [own, horizons] = [
        this.curves.height(this.drawn, x),
        this.curves.horizons(this.drawn, x),
      ];
      if (own === null || !looksLike(y, own)) return false;
      if (horizons === null || upper === undefined || lower === undefined) {
        return horizons === null && upper === undefined && lower === undefined;
      }
      return looksLike(upper, horizons.upper) && looksLike(lower, horizons.lower);
    },
    visibility: ({ x, flag }) => {
      const { upper, lower } = this.curves.reaches(this.drawn, x);
      return { '-1': lower, '0': !upper && !lower, '1': upper, '2': upper && lower }[flag];
    },
    intersection: ({ point, columns }) => this.isEnd(point, columns),
    draw_line: ({ from, fromColumns, to, toColumns }) => {
      const [first, last] = [toNumber(from[0]), toNumber(to[0])];
      for (let x = Math.floor(first) + 1; x < last; x++) {
        const { upper, lower } = this.curves.reaches(this.drawn, x);
        if (!upper && !lower) return false;
      }
      return this.isEnd(from, fromColumns) && this.isEnd(to, toColumns);
    },
  };

  isSo = (event: Event): boolean | null => claimed(this.claims, event);

  isSaidRightly(said: string): boolean {
    const [, x, is] = /Exactly: over column (\S+) it is (hidden|visible)/u.exec(said) ?? [];
    if (x === undefined) return true;
    const { upper, lower } = this.curves.reaches(this.drawn, numberIn(x));
    return (is === 'visible') === (upper || lower);
  }
}

const zero = new Rational(0n);
const numberIn = (text: string): number => Number(text.replace('−', '-'));
type Run = Readonly<Record<'row' | 'first' | 'end', number>>;
const asRun = ([row, first, end]: readonly [number, number, number]): Run => ({ row, first, end });
const pixelsOf = ({ row, first, end }: Run): readonly (readonly [number, number])[] =>
  Array.from({ length: end - first }, (_, i) => [first + i, row]);
const digits = (value: number): string => short(value).replace('≈', '');
/** Whether the digits that a sentence shows are right; half of the last one may be rounded either way. */
function looksLike(computed: N, exact: Rational): boolean {
  if (typeof computed === 'string') return Rational.of(computed).against(exact) === 0;
  const right = exact.number;
  return (
    Math.abs(computed - right) <= 1e-12 * Math.abs(right) || digits(computed) === digits(right)
  );
}

const met = { right: 0, wrong: 0 };
const names = new Set<EventName>();

async function faultsOf(run: RandomRun): Promise<readonly string[]> {
  const { trace: text } = await make(program ?? '', run);
  const [header, ...lines] = text.trim().split('\n').slice(0, -1);
  const { scene } = JSON.parse(header ?? '') as { scene: SceneFile | SurfaceFile };
  const truth = 'curves' in scene ? new TruthOfCurves(scene) : new Truth(scene);
  const trace = await traceOf(text);
  const { method, edition, kernel } = run.options;
  const neverErrs = edition === 'corrected' && !/^(?:float|double|bits|depth)/u.test(kernel);
  return lines.flatMap((line, i) => {
    const event = JSON.parse(line) as Event;
    const said = trace.timeline.sentence(i + 1, 'en');
    const isMarked = isCorrected(said);
    const fault = (what: string): readonly string[] => [`${line} “${said}” ${what}`];
    if (neverErrs) return isMarked ? fault('is marked, and cannot be wrong') : [];
    // Polygons that are edge-on show as lines there.
    if (method === 'warnock-edges') return [];
    const isSo = truth.isSo(event);
    if (isSo !== null) {
      met[isSo ? 'right' : 'wrong']++;
      if (!isSo) names.add(event.e);
      if (isSo === isMarked) return fault(isSo ? 'is so, and marked' : 'is not so, and not marked');
    }
    const [, named] = /Exactly: .*?pixel \((−?\d+, −?\d+)\)/u.exec(said) ?? [];
    const place = correctedPixel(said)?.join(', ').replaceAll('-', '−');
    if (place !== named) return fault(`marks ${place} instead of the pixel that it names`);
    return truth.isSaidRightly(said) ? [] : fault('states another truth');
  });
}

describe.runIf(program !== undefined)(`the sentences of ${count} random runs`, () => {
  it('state as so only what is so by exact arithmetic', async () => {
    const waiting = [...randomRuns(count, 2027)];
    const wrong: string[] = [];
    const work = async (): Promise<void> => {
      for (let run = waiting.pop(); run !== undefined; run = waiting.pop()) {
        const found = await faultsOf(run);
        wrong.push(...found.map((each) => `${Object.values(run.options).join(' ')}: ${each}`));
      }
    };
    await Promise.all(Array.from({ length: 4 }, work));
    expect(wrong.slice(0, 20)).toEqual([]);
    // Both cases occurred, the wrong ones in most kinds of claims.
    expect(met.right).toBeGreaterThan(count);
    expect(names.size).toBeGreaterThan(7);
  }, 900_000);
});
