import type { ExactTexts } from '../../language/exact-texts.js';
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

export const exact: ExactTexts = {
  exactness: 'Exact?',
  decided: decisionWords.en,
  causes: causeWords.en,
  answer,
  computed: 'Computed',
  exact: 'Exactly',
  decidedBy: 'Decided by',
  stages: {
    given: 'the given coordinates',
    scene: 'a bound for the whole scene',
    operands: 'a bound for these numbers',
    exact: 'exact arithmetic',
  },
  right: 'Right.',
  wrong: 'Wrong.',
  undefined: 'The run took a wrong branch before, so there is no right answer here.',
  unchecked: 'Not checked: this run was not compared with exact arithmetic.',
  notChecked: 'not checked',
  checking: 'Checking every decision of this run…',
  checkingShort: 'checking…',
  found: (wrong) =>
    wrong === 0
      ? 'Checked: every decision of this run is right.'
      : `Checked: this run decides wrongly at ${wrong} ${wrong === 1 ? 'step' : 'steps'}.`,
  foundNoneBut:
    'Checked: every decision is as in exact arithmetic. But this is not the corrected text, so the picture may still be wrong.',
  unable: {
    otherRun:
      'Not checked: the library runs this scene differently. Another program, or another version, made this trace.',
    notHere: 'Not checked: the library does not run this text with these numbers.',
    tooLong: 'Not checked: the checked run would be too long for this page.',
    failed: 'Not checked: the library could not run this scene again.',
  },
  certain: 'With these numbers every decision is exact.',
  check: 'Check every decision',
  findings: {
    title: 'Decisions worth looking at',
    count: (count) => (count === 1 ? '1 decision' : `${count} decisions`),
    withNumbers: 'include equal numbers',
    more: 'Show more',
    polygons: 'Polygons',
    columns: { step: 'Step', kind: 'Kind', ulps: 'Ulps from zero' },
    kinds: { wrong: 'wrong', point: 'point is off', zero: 'exactly zero', narrow: 'narrow' },
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
    pixels: (off) => `${off} pixels`,
    gap: (computed, exactly) => `Difference: computed ${computed}, exact ${exactly}`,
    decides: (pixels) => `Decides the pixels ${pixels}`,
  },
  margin: {
    edge: (edge, at) => `edge ${edge} over ${at}`,
    vertex: (side) => `vertex over the ${side} side`,
    edgeAtCorner: (edge, corner) => `edge ${edge} over the ${corner.replace('-', ' ')} corner`,
  },
  byHand: 'Step by step',
  byHandWith: { used: 'With the numbers of this run', exact: 'With the exact numbers' },
  noNumbers: 'One of the numbers is undefined or infinite.',
  nothing: 'No numeric decision at this step. Go to a sign, a comparison or a range.',
  findWrong: '“Go to: a wrong decision” finds the wrong ones.',
  lens: (at) => `The same decision around ${at}`,
  apart: (ulp) => `Each square is a neighbouring number, ${ulp} apart.`,
  noLens:
    'This decision has no map. Only signs and comparisons of two polygons’ depths have one, and not with every kind of number.',
  drawing: 'Computing at each neighbour…',
  wrongPlaces: (wrong, all) =>
    wrong === 0 ? `Right at all ${all} places.` : `Wrong at ${wrong} of ${all} places.`,
  drifted:
    'The map computes both depths from the planes. This run accumulated its depth along the row, so its answer differs.',
  cell: (x, y, computed, exactly) =>
    `x ${ulps(x)}, y ${ulps(y)} ulp: computed ${computed}, exact ${exactly}`,
  signs: { '-1': 'negative', 0: 'zero', 1: 'positive' },
  yesNo: { '-1': 'no', 0: 'no', 1: 'yes' },
  pale: 'pale: right',
  dark: 'dark: wrong',
};
