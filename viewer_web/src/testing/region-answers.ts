import { expect } from 'vitest';
import { texts } from '../i18n/index.js';
import { point, toNumber } from '../language/words.js';
import { stepsOf } from '../predict/ahead.js';
import type { Given, Kind, Question } from '../predict/question.js';
import { holds } from '../weiler-atherton/geometry.js';
import type { Piece, Point, Region } from '../trace/values.js';
import { sorted } from './questions.js';
import type { Agrees } from './questions.js';

const idsOf = (pieces: readonly Piece[] = []): readonly string[] =>
  sorted([...new Set(pieces.map(([id]) => id))]);

/** Whether a region contains the midpoint of an edge piece; null if the midpoint is too close to the region's outline. */
function holdsMiddle(region: Region, from: Point, to: Point): boolean | null {
  const [x, y] = [0, 1].map((i) => (toNumber(from[i] ?? 'nan') + toNumber(to[i] ?? 'nan')) / 2);
  const around = [-1e-6, 1e-6].flatMap((off) => [
    holds(region, [(x ?? NaN) + off, y ?? NaN]),
    holds(region, [x ?? NaN, (y ?? NaN) + off]),
  ]);
  return new Set(around).size === 1 ? (around[0] ?? null) : null;
}

type RegionKind = Extract<
  Kind,
  'piercing' | 'sort' | 'parted' | 'entering' | 'walk' | 'behind' | 'stack'
>;

/** The subjects of a part, or the labels of its typed answer. */
const givenOf = ({ parts }: Question, asks: string): readonly Given[] =>
  parts.find((part) => part.asks === asks)?.given ?? [];

/** The expected answers to the questions about Weiler and Atherton's algorithm. */
export const regionsAgree: Readonly<Record<RegionKind, Agrees>> = {
  piercing: ({ after, right }) => {
    const { facets = [] } = after.weilerAtherton ?? {};
    const ids = facets.map(([id]) => id);
    const split = ids.filter((id, i) => ids.indexOf(id) !== i);
    expect(sorted(right['pierced'])).toEqual(sorted([...new Set(split)]));
    expect(right['pieces']).toEqual([String(facets.length)]);
  },
  sort: ({ trace, question, right }) => {
    const { lists = [] } = trace.timeline.seek(question.until + 1).values.weilerAtherton ?? {};
    expect(right['first']).toEqual([lists.at(-1)?.[0]?.[0]]);
    const depths = question.parts[1]?.options.map(({ value }) => value) ?? [];
    const numbers = depths.map((z) => toNumber(z.includes('/') ? z : Number(z)));
    expect(right['depth']).toEqual([depths[numbers.indexOf(Math.max(...numbers))]]);
  },
  parted: ({ question, after, right }) => {
    const { inside = [], outside = [] } = after.weilerAtherton?.currentList ?? {};
    expect(sorted(right['within'])).toEqual(idsOf(inside));
    expect(sorted(right['beyond'])).toEqual(idsOf(outside));
    for (const { value } of givenOf(question, 'outlines')) {
      const loops = outside.filter(([id]) => id === value).flatMap(([, region]) => region);
      expect(right['outlines']).toEqual([String(loops.length)]);
    }
  },
  entering: ({ trace, question, before, right }) => {
    const clip = before.weilerAtherton?.currentList?.pieces[0]?.[1] ?? [];
    const pieces = stepsOf(trace, question.step, question.until, 'edge_piece');
    for (const { event } of pieces) {
      const last = pieces.find((each) => point(each.event.to) === point(event.from))?.event;
      const was = last === undefined ? null : holdsMiddle(clip, last.from, last.to);
      const is = holdsMiddle(clip, event.from, event.to);
      if (was === null || is === null) continue;
      expect(right['enters']?.includes(point(event.from))).toBe(!was && is);
      expect(right['leaves']?.includes(point(event.from))).toBe(was && !is);
    }
  },
  walk: ({ question, after, right }) => {
    if (question.kind !== 'walk') return;
    const points = givenOf(question, 'walked');
    const walked = [question.about.from, ...(right['walked'] ?? [])].map((number) =>
      points.find(({ value }) => value === number)?.note?.(texts.en),
    );
    const [, region = []] = after.weilerAtherton?.currentList?.inside.at(-1) ?? [];
    const loops = region
      .map((loop) => loop.map(point))
      .filter((each) => each.length === walked.length);
    expect(loops.map((loop) => [...loop, ...loop].join()).join('; ')).toContain(walked.join());
  },
  behind: ({ trace, question, before, after, right }) => {
    const inside =
      before.weilerAtherton?.currentList?.inside.filter(([, , ground]) => !ground) ?? [];
    const left = after.weilerAtherton?.currentList?.inside.map(([id]) => id) ?? [];
    const gone = inside.map(([id]) => id).filter((id) => !left.includes(id));
    expect(sorted(right['hidden'])).toEqual(sorted(gone));
    // A clip polygon that no inside part hides is visible at the next step.
    const isShown = trace.timeline.event(question.until + 1)?.e === 'show';
    expect(right['next']).toEqual([isShown ? 'visible' : 'again']);
  },
  stack: ({ after, right }) => {
    const { pieces = [] } = after.weilerAtherton?.currentList ?? {};
    expect(right['clips']).toEqual([pieces[0]?.[0]]);
    expect(sorted(right['listed'])).toEqual(idsOf(pieces));
  },
};
