import { methodTitles } from '../../language/family.js';
import { costs, errors } from './chart-axes.js';
import { subjects } from './chart-subjects.js';
import { family } from './family.js';

export const chart = {
  question: 'What does a right picture cost?',
  ownFile: 'Your own chart',
  openFile: 'Open a file…',
  dropHere: 'or drop it here: .json',
  subjects,
  kinds: { ordinary: 'Ordinary', degenerate: 'Degenerate', surfaces: 'Surfaces' },
  allOf: {
    ordinary: (count: string): string => `All ordinary scenes (${count})`,
    degenerate: (count: string): string => `All degenerate scenes (${count})`,
    surfaces: (count: string): string => `All surfaces (${count})`,
  },
  aboutScene: (pixels: string, polygons: string, unsteady: string): string =>
    `pixels: ${pixels} · polygons: ${polygons} · pixels that an ulp may change: ${unsteady}`,
  aboutSurface: (curves: string, columns: string): string =>
    `curves: ${curves} · columns of all curves: ${columns} · the cost of drawing alone, without that of sampling`,
  cost: 'Cost',
  error: 'Error',
  add: 'Add',
  nothingMore: 'nothing',
  right: 'right',
  wrong: 'wrong',
  cheapestMark: 'the cheapest right one',
  methods: { ...methodTitles('en'), ...family.methods },
  /** Warnock's algorithm. */
  variants: 'Variants of Warnock',
  variantNames: family.names,
  knobs: {
    bits: 'bits',
    depth: 'depth bits',
    grid: 'grid',
    window: 'window',
    samples: 'samples',
    tolerance: 'tolerance',
  },
  turned: {
    bits: (value: string): string => `arithmetic of ${value} bits`,
    depth: (value: string): string => `Z-buffer of ${value} bits`,
    grid: (value: string): string => `sub-pixel grid of ${value} bits`,
    window: (value: string): string => `smallest window: ${value} px`,
    samples: (value: string): string => `${value} samples per curve`,
    tolerance: (value: string): string => `tolerance ${value} px`,
  },
  editions: { printed: 'as printed' },
  fault: 'stopped by a fault',
  printed: 'text as printed',
  costs,
  errors,
  counted: (part: string, all: string): string => `${part} of ${all}`,
  units: {
    depthUlps: (count: string): string => `${count} ulps`,
    height: (count: string): string => `${count} px`,
  },
  about: 'What the axes measure',
  reading:
    'Farther left is cheaper. Above the line the picture is wrong, the higher the worse; below it the picture is right.',
  missing: (kernels: string): string =>
    `Not shown because their numbers have no fixed width: ${kernels}.`,
  plot: (cost: string, error: string): string => `${error} against ${cost}`,
  keys: 'Keys: ← → by cost, ↑ ↓ by error, Home, End; Esc closes.',
  front: 'the front: nothing is cheaper and as right',
  table: 'The points as a table',
  run: 'Run',
  whichRun: 'Which run to choose',
  advice: {
    cheapest: 'Cheapest right here',
    safe: 'Cheapest right everywhere',
    wrong: 'Cheaper, but wrong',
    same: (run: string): string =>
      `${run} is the cheapest right run, and it is right everywhere, since it decides as exact arithmetic does.`,
    safer: (run: string, times: string): string =>
      `${run} is the cheapest right run; one that is right everywhere, not only here, costs ${times} times as much.`,
    unsafe: (run: string): string =>
      `${run} is the cheapest right run; by this measure, no run that is right everywhere has a cost.`,
  },
  noRun: 'none',
  panel: {
    title: 'The chosen run',
    hint: 'Click a point, or choose one by keyboard.',
    own: 'Its picture',
    right: 'The exact one',
    replay: 'Replay this run',
    compare: 'Compare with the exact run',
    unlinked: {
      window: 'The page cannot run the method with a larger smallest window.',
      large: 'The file is too large for a link: open it on the page.',
    },
  },
  empty: 'No chart is open.',
  howTo: 'This command writes a chart of every way to run these scenes:',
  unreadable: (name: string, where: string, reason: string): string =>
    `${name} cannot be read as a chart. ${where === '' ? '' : `${where}: `}${reason}.`,
  broken: (name: string): string => `${name} could not be read.`,
};
