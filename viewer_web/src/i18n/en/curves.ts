import type { N } from '../../trace/values.js';
import { short } from '../../language/words.js';

export const curves = {
  curve: (curve: number): string => `Curve ${curve}`,
  current: 'curve',
  segment: 'segment',
  edges: 'Side edges',
  left: 'left',
  right: 'right',
  column: 'column',
  upper: 'upper',
  lower: 'lower',
  looked: 'flag',
  lines: 'lines so far',
  flags: {
    above: '1, above',
    below: '−1, below',
    hidden: '0, hidden',
    both: '2, both',
  },
  layers: {
    lines: 'lines so far',
    curve: 'current curve',
    horizons: 'horizons',
    columns: 'flags of columns',
    edges: 'side edges',
  },
  layersName: 'What the picture shows',
  around: (column: string): string => `Horizons around column ${column}`,
  history: {
    pixel: 'Column',
    at: (x: number): string => `Column ${x}`,
    /** The horizons over a column, for its announcement: their y, null without one. */
    horizons: (upper: N | null, lower: N | null): string =>
      `${upper === null ? 'no upper horizon' : `upper horizon ${short(upper)}`}, ${lower === null ? 'no lower horizon' : `lower horizon ${short(lower)}`}`,
    /** Includes the key if single-character keys are on. */
    hint: (key: string | null): string =>
      `Click a column of the picture${key === null ? '' : `, or press ${key},`} to see every curve over it, each flag and each change of the horizons.`,
    how: 'The left and right arrow keys move by one column, with Shift by ten. Enter shows the history of the column. Escape leaves the picture.',
    forget: 'Forget the column',
    entries: 'Everything that happened over the column',
    outcomes: { pass: 'visible', fail: 'hidden', paint: 'drawn', wrong: 'wrong', note: '' },
    painted: (step: number): string => `Last drawn over at step ${step}`,
    unpainted: 'No curve is drawn over it.',
  },
  surface: {
    own: 'A surface y = f(x, z)…',
    name: 'Surface',
    how: 'Drag a sample of the current curve up or down, or press the up and down arrow keys. Or change the function.',
    title: 'Surface',
    function: 'y as a function of x and z',
    language:
      'x, z, pi; + − * / ^, comparisons, ? :; sin, cos, tan, asin, acos, atan, atan2, sinh …, exp, ln, log2, log10, sqrt, abs, sign, min, max, sum, avg.',
    sampled: (curves: number, samples: number): string =>
      `${curves} curves with ${samples} samples, given as numbers. Moving a sample replaces the function by numbers.`,
    give: 'Give a function instead',
    ends: { x: ['x, left', 'x, right'], z: ['z, nearest', 'z, farthest'] },
    curves: 'curves',
    samples: 'samples',
    tolerance: 'tolerance',
    toleranceHint:
      'In pixels: where a curve is farther than this from the line between two samples, one more sample is added halfway. Empty: no more samples',
    up: 'pixels up',
    ways: {
      origin: 'Left end of the nearest curve, at y = 0',
      across: 'From a curve’s left end to its right one',
      back: 'From a curve to the next',
    },
    /** The labels of x and y for a direction on the screen. */
    place: ['columns', 'rows'],
    sample: (curve: number, x: number, y: number): string =>
      `Curve ${curve}, column ${x}: y = ${y}`,
  },
};
