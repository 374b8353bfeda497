import { orderOf, point, short, toNumber } from '../language/words.js';
import type { Trace } from '../replay/trace.js';
import type { Detail, EventName, Method } from '../trace/events.js';
import type { Header, Polygon } from '../trace/header.js';
import type { N, Point } from '../trace/values.js';
import type { Kind, Note, Option, Question } from './question.js';

/** Asks questions of one kind. */
export interface Asker<K extends Kind = Kind> {
  /** Which variants' runs answer them, where not all do. */
  readonly isOf?: (method: Method) => boolean;
  /** The least detail that answers them. */
  readonly from: Detail;
  /** The events at which they may be asked. */
  readonly at: readonly EventName[];
  /** The question of a step, if the run goes on to answer it and it is not plain before. */
  ask(trace: Trace, step: number): Question<K> | null;
}

/** The kinds of question that the runs of an algorithm answer. */
export type Askers = { readonly [K in Kind]?: Asker<K> };

/** More options would be hard to survey. */
export const mostOptions = 8;

export const optionsOf = (values: readonly string[]): readonly Option[] =>
  values.map((value) => ({ value }));

/** Depths from the farthest to the nearest, in full where they would look alike. */
export function depthOptions(depths: readonly N[]): readonly Option[] {
  const all = [...new Set(depths)].sort((a, b) => toNumber(a) - toNumber(b));
  const areShort = new Set(all.map(short)).size === all.length;
  return all.map((z) => ({
    value: String(z),
    note: ({ numbers }) => (areShort ? numbers.short(z) : numbers.inFull(z)),
  }));
}

export type Relation = '>' | '=' | '<';
const relations: readonly Relation[] = ['>', '=', '<'];
export const relationBy = { '-1': '<', 0: '=', 1: '>' } as const satisfies Record<string, Relation>;
export const relationOptions = optionsOf(relations);

/** How a depth compares with the one before it; null where the numbers in the trace do not show it. */
export function relationOf(z: N, against: N, nearer: boolean, { kernel }: Header): Relation | null {
  const order = orderOf(z, against);
  if (order === null || (order === 1) !== nearer) return null;
  // Under `filtered` the numbers stand for others, which decide.
  return order === 0 && kernel === 'filtered' ? null : relationBy[order];
}

/** An edge by its ends. */
export function edgeNote({ vertices }: Polygon, edge: number): Note {
  const ends = [vertices[edge], vertices[(edge + 1) % vertices.length]];
  return ({ numbers: { point } }) =>
    ends.map((vertex) => point(vertex?.slice(0, 2) ?? [])).join(' → ');
}

/** Points as options; each is named in one way in all languages, and shown by its note. */
export const pointOptions = (points: readonly Point[]): readonly Option[] =>
  points.map((at) => ({ value: point(at), note: ({ numbers }) => numbers.point(at) }));
