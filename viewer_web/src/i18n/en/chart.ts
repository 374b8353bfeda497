import type { ChartTexts } from '../../language/chart-texts.js';
import { methodTitles } from '../../language/family-texts.js';
import { costs, errors } from './chart-axes.js';
import { subjects } from './chart-subjects.js';
import { family } from './family.js';

export const chart: ChartTexts = {
  tagline: 'what a correct picture costs',
  ownFile: 'Your own chart',
  openFile: 'Open a file…',
  dropHere: 'or drop it here: .json',
  subjects,
  kinds: { ordinary: 'Ordinary', degenerate: 'Degenerate', surfaces: 'Surfaces' },
  allOf: {
    ordinary: (count) => `All ordinary scenes (${count})`,
    degenerate: (count) => `All degenerate scenes (${count})`,
    surfaces: (count) => `All surfaces (${count})`,
  },
  aboutScene: (pixels, polygons, unsteady) =>
    `pixels: ${pixels} · polygons: ${polygons} · pixels that an ulp may change: ${unsteady}`,
  aboutSurface: (curves, columns) =>
    `curves: ${curves} · columns of all curves: ${columns} · the cost of drawing alone, without that of sampling`,
  cost: 'Cost',
  error: 'Error',
  series: 'Shown',
  methods: { ...methodTitles('en'), ...family.methods },
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
    bits: (value) => `arithmetic of ${value} bits`,
    depth: (value) => `Z-buffer of ${value} bits`,
    grid: (value) => `sub-pixel grid of ${value} bits`,
    window: (value) => `smallest window: ${value} px`,
    samples: (value) => `${value} samples per curve`,
    tolerance: (value) => `tolerance ${value} px`,
  },
  samplings: {
    samples: 'evenly spaced samples',
    tolerance: 'samples within a tolerance',
    fixed: 'samples from the file',
  },
  editions: { corrected: 'corrected', printed: 'as printed' },
  fault: 'stopped by a fault',
  printed: 'text as printed',
  printedLabel: (kernel) => `${kernel}, printed`,
  costs,
  errors,
  counted: (part, all) => `${part} of ${all}`,
  units: { depthUlps: (count) => `${count} ulps`, height: (count) => `${count} px` },
  reading:
    'Farther left is cheaper, farther down is better. In the bands marked 0 and ∞ all runs are equally right or wrong; their series are spread out only to tell them apart.',
  missing: (kernels) => `Not shown because their numbers have no fixed width: ${kernels}.`,
  rightPicture: (share) => `the correct picture itself: ${share}`,
  plot: (cost, error) => `${error} against ${cost}`,
  keys: 'Keys: ← → by cost, ↑ ↓ by error, Home, End; Esc closes.',
  front: 'The front: no other run is both as cheap and as right',
  frontMark: 'the front',
  run: 'Run',
  whichRun: 'Which run to choose',
  losses: {
    nothing: 'Its curves match the function over every column.',
    height: (pixels) => `Its curves are at most ${pixels} from the function.`,
    noDecision:
      'No run of the corrected text makes a wrong decision: the error comes from the samples alone.',
    decisions: (kernels) =>
      `The error comes from the samples and from arithmetic. Wrong decisions in a run of the corrected text, at most: ${kernels}.`,
  },
  operations: {
    windows: (share) => `${share} of its operations take a window from the stack`,
    boxes: (share) => `${share} of its operations are box tests`,
    depths: (share) => `${share} of its operations are depths of planes`,
    orientations: (share) => `${share} of its operations are orientation tests`,
    comparisons: (share) => `${share} of its operations are comparisons of depths`,
    intersections: (share) => `${share} of its operations are intersections`,
    rows: (share) => `${share} of its operations find the ends of rows`,
    edges: (share) => `${share} of its operations are steps of edges`,
    visibilities: (share) => `${share} of its operations compare a curve with the horizons`,
    horizons: (share) => `${share} of its operations set a horizon`,
    steps: (share) => `${share} of its operations search for a crossing`,
    crossings: (share) => `${share} of its operations compute a crossing`,
  },
  replay: {
    title: 'The chosen run',
    hint: 'Click a point, or choose one by keyboard.',
    replay: 'Replay this run',
    compare: 'Compare with the exact run',
    unlinked: {
      window: 'The page cannot run the method with a larger smallest window.',
      large: 'The file is too large for a link: open it on the page.',
    },
  },
  empty: 'No chart is open.',
  howTo: 'This command writes a chart of every way to run these scenes:',
  unreadable: (name, where, reason) =>
    `${name} cannot be read as a chart. ${where === '' ? '' : `${where}: `}${reason}.`,
  broken: (name) => `${name} could not be read.`,
};
