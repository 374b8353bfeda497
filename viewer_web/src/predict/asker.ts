import { orderOf, point, relationBy, short, toNumber } from '../language/words.js';
import type { Relation } from '../language/words.js';
import { point as dot } from '../picture/mark.js';
import type { Trace } from '../replay/trace.js';
import type { Detail, EventName, Method } from '../trace/events.js';
import type { Header, Polygon } from '../trace/header.js';
import type { N, Point } from '../trace/values.js';
import type { Kind, Note, Option, Question } from './question.js';

/** Makes questions of one kind. */
export interface Asker<K extends Kind = Kind> {
  /** Whether runs of a variant can answer them; without it, all can. */
  readonly isOf?: (method: Method) => boolean;
  /** The lowest level of detail that can answer them. */
  readonly from: Detail;
  /** The events at which they may be asked. */
  readonly at: readonly EventName[];
  /** The question at a step, if the run goes on to answer it and the answer is not obvious. */
  ask(trace: Trace, step: number): Question<K> | null;
}

/** The kinds of questions that the runs of an algorithm can answer. */
export type Askers = { readonly [K in Kind]?: Asker<K> };

/** More options would be confusing. */
export const mostOptions = 8;

export const optionsOf = (values: readonly string[]): readonly Option[] =>
  values.map((value) => ({ value }));

/** Depths from the farthest to the nearest, in full where their short forms are equal. */
export function depthOptions(depths: readonly N[]): readonly Option[] {
  const all = [...new Set(depths)].sort((a, b) => toNumber(a) - toNumber(b));
  const areShort = new Set(all.map(short)).size === all.length;
  return all.map((z) => ({
    value: String(z),
    note: ({ numbers }) => (areShort ? numbers.short(z) : numbers.inFull(z)),
  }));
}

const relations: readonly Relation[] = ['>', '=', '<'];
export const relationOptions = optionsOf(relations);

export const signBy = { '-1': '-', 0: '0', 1: '+' } as const;
export const signOptions = optionsOf(['+', '0', '-']);

/** The relation of a depth to the one before it; null if the numbers in the trace do not show it. */
export function relationOf(z: N, against: N, nearer: boolean, { kernel }: Header): Relation | null {
  const order = orderOf(z, against);
  if (order === null || (order === 1) !== nearer) return null;
  // Under `filtered` other numbers decide than those in the trace.
  return order === 0 && kernel === 'filtered' ? null : relationBy[order];
}

/** The endpoints of an edge, as a note. */
export function edgeNote({ vertices }: Polygon, edge: number): Note {
  const ends = [vertices[edge], vertices[(edge + 1) % vertices.length]];
  return ({ numbers: { point } }) =>
    ends.map((vertex) => point(vertex?.slice(0, 2) ?? [])).join(' → ');
}

/** The kernels whose numbers agree with the exact ones in the decimals that an answer needs. */
const precise: ReadonlySet<string> = new Set(['double', 'filtered', 'exact']);
/** A double of this size, the result of a few operations, still has these decimals. */
const mostPrecise = 2 ** 20;

/** The right cells of a table; null if a careful calculation by hand may differ from a number of the run. */
export function cellsOf(values: readonly N[], { kernel }: Header): readonly string[] | null {
  const numbers = values.map(toNumber);
  const areSure = precise.has(kernel) && numbers.every((each) => Math.abs(each) < mostPrecise);
  return areSure ? numbers.map(String) : null;
}

/** Two numbers to compare, as a note that shows their difference. */
export const comparedNote =
  (one: N, other: N): Note =>
  ({ numbers: { shortApart } }) =>
    shortApart(one, other).join(' ? ');

/** Points as options. Their value is independent of the language, and their note is what is shown. */
export const pointOptions = (points: readonly Point[]): readonly Option[] =>
  points.map((at) => ({
    value: point(at),
    note: ({ numbers }) => numbers.point(at),
    places: [dot('pointed', at)],
  }));
