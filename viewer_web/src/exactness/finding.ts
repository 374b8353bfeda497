import { oneOf, part, whole } from '../trace/check.js';
import type { Decision } from '../trace/events.js';
import type { Answer, N, Operands } from '../trace/values.js';

export const findingKinds = ['wrong', 'point', 'zero', 'narrow'] as const;
export type FindingKind = (typeof findingKinds)[number];

export const coincidences = [
  'point_on_line',
  'equal_depths',
  'parallel_lines',
  'shared_points',
  'on_pixel_centre',
  'box_on_window',
  'curve_on_horizon',
  'equal_numbers',
] as const;
export type Coincidence = (typeof coincidences)[number];

/** A decision worth looking at; FORMAT.md describes the fields. */
export interface Finding {
  readonly kind: FindingKind;
  readonly step: number;
  /** False if the level of detail lacks the decision; the step then contains it. */
  readonly isShown?: boolean;
  readonly at: string;
  readonly procedure: string;
  readonly polygons: readonly string[];
  readonly pixels: readonly [x: number, y: number, width: number, height: number];
  readonly off?: number;
  readonly of?: Decision;
  readonly taken?: Answer;
  readonly exact?: Answer;
  readonly cause?: 'rounded' | 'drifted';
  readonly coincidence?: Coincidence;
  readonly computed?: N;
  readonly gap?: string;
  readonly sign?: -1 | 0 | 1;
  readonly ulps?: number;
  readonly operands: Operands;
}

/** Ulps from zero: a decision at most this far away is narrow. */
export const narrow = 2 ** 10;

const kindAndStep = part({ kind: oneOf(...findingKinds), step: whole });

/**
 * The list of a run, as `vidno check --list` writes it, after a first line that identifies the run. That has the narrowest
 * decisions of the run, however wide they are; here they are left out unless they are narrow.
 */
export function findingsIn(lines: string): readonly Finding[] {
  return lines
    .split('\n')
    .slice(1)
    .filter((line) => line !== '')
    .map((line) => {
      const found: unknown = JSON.parse(line);
      kindAndStep(found, '');
      return found as Finding;
    })
    .filter(({ kind, ulps = Infinity }) => kind !== 'narrow' || ulps <= narrow);
}

/** The possible orders of the list. */
export const orders = ['step', 'kind', 'ulps'] as const;
export type Order = (typeof orders)[number];

const widths = ({ ulps = Infinity }: Finding): number => ulps;
const comparers: Readonly<Record<Order, (a: Finding, b: Finding) => number>> = {
  step: () => 0,
  kind: (a, b) => findingKinds.indexOf(a.kind) - findingKinds.indexOf(b.kind),
  ulps: (a, b) => (widths(a) === widths(b) ? 0 : widths(a) - widths(b)),
};

/** Sorted; equal ones step by step. */
export const sortedBy = (order: Order, findings: readonly Finding[]): readonly Finding[] =>
  [...findings].sort((a, b) => comparers[order](a, b) || a.step - b.step);

/** Whether a finding is shown. Equal numbers in a sort or a box are not a visible coincidence. */
export const isSeen = ({ kind, coincidence }: Finding): boolean =>
  kind !== 'zero' || coincidence !== 'equal_numbers';
