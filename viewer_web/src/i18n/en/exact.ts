import type { WindowSide, WindowCorner } from '../../exactness/margin.js';
import { causeWords, decisionWords } from '../../trace/event-table.js';
import type { Answer } from '../../trace/values.js';

const answer = (value: Answer): string => {
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value === 'number') return String(value).replace('-', '−');
  const [first, end] = value;
  if (end - first === 1) return String(first);
  return first < end ? `${first} to ${end - 1}` : 'none';
};

const ulps = (n: number): string => `${n > 0 ? '+' : n < 0 ? '−' : ''}${Math.abs(n)}`;

export const exact = {
  exactness: 'Exact?',
  /** Used in the middle of a sentence. */
  decided: decisionWords.en as Readonly<Record<keyof typeof decisionWords.en, string>>,
  causes: causeWords.en as Readonly<Record<keyof typeof causeWords.en, string>>,
  answer,
  computed: 'Computed',
  exact: 'Exactly',
  unchecked: 'Not checked: this run was not compared with exact arithmetic.',
  /** Shown in place of the number of wrong decisions. */
  notChecked: 'not checked',
  checking: 'Checking every decision of this run…',
  /** Shown in place of the number of wrong decisions during the check. */
  checkingShort: 'checking…',
  found: (wrong: number): string =>
    wrong === 0
      ? 'Checked: every decision of this run is right.'
      : `Checked: this run decides wrongly at ${wrong} ${wrong === 1 ? 'step' : 'steps'}.`,
  /** No decision is wrong, but the text is not the corrected one. */
  foundNoneBut:
    'Checked: every decision is as in exact arithmetic. But this is not the corrected text, so the picture may still be wrong.',
  unable: {
    otherRun:
      'Not checked: the library runs this scene differently. Another program, or another version, made this trace.',
    notHere: 'Not checked: the library does not run this text with these numbers.',
    tooLong: 'Not checked: the checked run would be too long for this page.',
    failed: 'Not checked: the library could not run this scene again.',
  },
  check: 'Check every decision',
  /** The list of decisions worth looking at. */
  findings: {
    title: 'Decisions worth looking at',
    count: (count: number): string => (count === 1 ? '1 decision' : `${count} decisions`),
    withNumbers: 'include equal numbers',
    within:
      'This level of detail does not show all of these decisions. Those with ⊃ lead to the step that contains them; trace the run at level signs to see them.',
    more: 'Show more',
    polygons: 'Polygons',
    columns: { step: 'Step', kind: 'Kind', ulps: 'Ulps from zero' },
    kinds: { wrong: 'wrong', point: 'point is off', zero: 'exactly zero', narrow: 'narrow' },
    narrowBy: (ulps: number): string => `narrow: at most ${ulps} ulps from zero`,
    coincidences: {
      point_on_line: 'point on a line',
      equal_depths: 'equal depths',
      parallel_lines: 'parallel lines',
      shared_points: 'shared point',
      on_pixel_centre: 'on a pixel centre',
      box_on_window: 'box touches the window',
      curve_on_horizon: 'curve on the horizon',
      equal_numbers: 'equal numbers',
    },
    pixels: (off: string): string => `${off} pixels`,
    /** The difference between two numbers. */
    gap: (computed: string, exactly: string): string =>
      `Difference: computed ${computed}, exact ${exactly}`,
    decides: (pixels: string): string => `Decides the pixels ${pixels}`,
  },
  /** The effect of moving a vertex across a side of its margin. */
  margin: {
    edge: (edge: number, at: string): string => `edge ${edge} over ${at}`,
    vertex: (side: WindowSide): string => `vertex over the ${side} side`,
    edgeAtCorner: (edge: number, corner: WindowCorner): string =>
      `edge ${edge} over the ${corner.replace('-', ' ')} corner`,
  },
  nothing: 'No numeric decision at this step. Go to a sign, a comparison or a range.',
  findWrong: '“Go to: a wrong decision” finds the wrong ones.',
  lens: (at: string): string => `The same decision around ${at}`,
  apart: (ulp: string): string => `Each square is a neighbouring number, ${ulp} apart.`,
  noLens:
    'This decision has no map. Only signs and comparisons of two polygons’ depths have one, and not with every kind of number.',
  drawing: 'Computing at each neighbour…',
  wrongPlaces: (wrong: number, all: number): string =>
    wrong === 0 ? `Right at all ${all} places.` : `Wrong at ${wrong} of ${all} places.`,
  drifted:
    'The map computes both depths from the planes. This run accumulated its depth along the row, so its answer differs.',
  /** The signs at a place the given number of ulps away. */
  cell: (x: number, y: number, computed: string, exactly: string): string =>
    `x ${ulps(x)}, y ${ulps(y)} ulp: computed ${computed}, exact ${exactly}`,
  signs: { '-1': 'negative', 0: 'zero', 1: 'positive' },
  yesNo: { '-1': 'no', 0: 'no', 1: 'yes' },
  pale: 'pale: right',
  dark: 'dark: wrong',
};
