import { methodTitles } from '../../language/family.js';
import { costs, errors } from './chart-axes.js';
import { subjects } from './chart-subjects.js';
import { family } from './family.js';

export const chart = {
  tagline: 'what a correct picture costs',
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
  series: 'Shown',
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
  /** How a surface's curves may be sampled. */
  samplings: {
    samples: 'evenly spaced samples',
    tolerance: 'samples within a tolerance',
    fixed: 'samples from the file',
  },
  editions: { corrected: 'corrected', printed: 'as printed' },
  fault: 'stopped by a fault',
  printed: 'text as printed',
  printedLabel: (kernel: string): string => `${kernel}, printed`,
  costs,
  errors,
  counted: (part: string, all: string): string => `${part} of ${all}`,
  units: {
    depthUlps: (count: string): string => `${count} ulps`,
    height: (count: string): string => `${count} px`,
  },
  reading:
    'Farther left is cheaper, farther down is better. In the bands marked 0 and ∞ all runs are equally right or wrong; their series are spread out only to tell them apart.',
  missing: (kernels: string): string =>
    `Not shown because their numbers have no fixed width: ${kernels}.`,
  rightPicture: (share: string): string => `the correct picture itself: ${share}`,
  plot: (cost: string, error: string): string => `${error} against ${cost}`,
  keys: 'Keys: ← → by cost, ↑ ↓ by error, Home, End; Esc closes.',
  front: 'The front: no other run is both as cheap and as right',
  frontMark: 'the front',
  run: 'Run',
  whichRun: 'Which run to choose',
  losses: {
    nothing: 'Its curves match the function over every column.',
    height: (pixels: string): string => `Its curves are at most ${pixels} from the function.`,
    noDecision:
      'No run of the corrected text makes a wrong decision: the error comes from the samples alone.',
    decisions: (kernels: string): string =>
      `The error comes from the samples and from arithmetic. Wrong decisions in a run of the corrected text, at most: ${kernels}.`,
  },
  operations: {
    windows: (share: string): string => `${share} of its operations take a window from the stack`,
    boxes: (share: string): string => `${share} of its operations are box tests`,
    depths: (share: string): string => `${share} of its operations are depths of planes`,
    orientations: (share: string): string => `${share} of its operations are orientation tests`,
    comparisons: (share: string): string => `${share} of its operations are comparisons of depths`,
    intersections: (share: string): string => `${share} of its operations are intersections`,
    rows: (share: string): string => `${share} of its operations find the ends of rows`,
    edges: (share: string): string => `${share} of its operations are steps of edges`,
    visibilities: (share: string): string =>
      `${share} of its operations compare a curve with the horizons`,
    horizons: (share: string): string => `${share} of its operations set a horizon`,
    steps: (share: string): string => `${share} of its operations search for a crossing`,
    crossings: (share: string): string => `${share} of its operations compute a crossing`,
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
  unreadable: (name: string, where: string, reason: string): string =>
    `${name} cannot be read as a chart. ${where === '' ? '' : `${where}: `}${reason}.`,
  broken: (name: string): string => `${name} could not be read.`,
};
