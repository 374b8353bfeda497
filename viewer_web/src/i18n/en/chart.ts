import type { ChartTexts } from '../chart.js';
import { family } from './family.js';

export const chart: ChartTexts = {
  tagline: 'what a right picture costs',
  ownFile: 'Your own chart',
  openFile: 'Open a file…',
  dropHere: 'or drop it here: .json',
  show: 'Scene',
  kinds: { ordinary: 'Ordinary', degenerate: 'Degenerate' },
  allOf: {
    ordinary: (count) => `All ordinary scenes (${count})`,
    degenerate: (count) => `All degenerate scenes (${count})`,
  },
  aboutScene: (pixels, polygons, unsteady) =>
    `pixels: ${pixels} · polygons: ${polygons} · pixels that an ulp may change: ${unsteady}`,
  cost: 'Cost',
  error: 'Error',
  series: 'Shown',
  methods: {
    warnock: 'Warnock',
    zbuffer: 'Z-buffer',
    ...family.methods,
  },
  variants: 'Variants of Warnock',
  variantNames: family.names,
  knobs: { bits: 'bits', depth: 'depth bits', grid: 'grid', window: 'window' },
  turned: {
    bits: (value) => `arithmetic of ${value} bits`,
    depth: (value) => `Z-buffer of ${value} bits`,
    grid: (value) => `sub-pixel grid of ${value} bits`,
    window: (value) => `smallest window: ${value} px`,
  },
  fixed: 'float, double…',
  editions: { corrected: 'corrected', printed: 'as printed' },
  fault: 'ended by a fault',
  printed: 'text as printed',
  printedLabel: (kernel) => `${kernel}, printed`,
  costs: {
    time: {
      name: 'Time',
      axis: 'time, relative to the fastest run',
      ratioAxis: 'time, relative to the fastest run',
      sentence: (rounds) =>
        `Time is that of a picture without a trace, the median of ${rounds} rounds, relative to the scene’s fastest run.`,
      ratioSentence:
        'Time is relative to the fastest run of each scene: the geometric mean over the scenes.',
    },
    operations: {
      name: 'Operations',
      axis: 'operations',
      ratioAxis: 'operations, relative to the fewest',
      sentence: () => 'Operations are the elementary steps of the listings.',
      ratioSentence:
        'Operations are relative to the fewest of each scene: the geometric mean over the scenes.',
    },
    bits: {
      name: 'Bits',
      axis: 'operations × bits',
      ratioAxis: 'operations × bits, relative to the fewest',
      sentence: () =>
        'Bits are the operations times the bits of the numbers that they are made on.',
      ratioSentence:
        'Bits, operations times the bits of their numbers, are relative to the fewest of each scene: the geometric mean over the scenes.',
    },
  },
  errors: {
    wrongPixels: {
      name: 'Wrong pixels',
      axis: 'wrong pixels, of all',
      sentence: 'Wrong pixels differ from the picture rule.',
      meanSentence: 'Wrong pixels differ from the picture rule: the mean share over the scenes.',
    },
    area: {
      name: 'Area',
      axis: 'area of difference, of all',
      sentence: 'The area is that by which the picture differs from the visible regions.',
      meanSentence:
        'The area is that by which the picture differs from the visible regions: the mean share over the scenes.',
    },
    wrongDecisions: {
      name: 'Wrong decisions',
      axis: 'wrong decisions, of all',
      sentence: 'Wrong decisions differ from exact arithmetic.',
      meanSentence: 'Wrong decisions differ from exact arithmetic: the mean share over the scenes.',
    },
    depthUlps: {
      name: 'Depth',
      axis: 'farthest depth, ulps',
      sentence: 'Depth is how far a computed one is from the polygon’s plane at most, in ulps.',
      meanSentence:
        'Depth is how far a computed one is from the polygon’s plane at most, in ulps: the farthest in any of the scenes.',
    },
  },
  counted: (part, all) => `${part} of ${all}`,
  ulps: (count) => `${count} ulps`,
  reading:
    'Farther left is cheaper, farther down is better. In the bands marked 0 and ∞ all are equally right or wrong: there the series only stand apart.',
  missing: (kernels) => `Not shown, for their numbers have no one width: ${kernels}.`,
  missingSomewhere: (kernels) =>
    `Not shown, for not every scene has a number for them: ${kernels}.`,
  rightPicture: (share) => `the right picture itself: ${share}`,
  plot: (cost, error) => `${error} against ${cost}`,
  keys: 'Keys: ← → by cost, ↑ ↓ by error, Home, End; Esc closes.',
  front: 'The front: no other run is as cheap and as right',
  frontMark: 'the front',
  run: 'Run',
  advice: {
    title: 'Which run is needed',
    none: 'No run gets every pixel right.',
    cheapest: (run, cost, amount) =>
      `${run} is the cheapest of those that get every pixel right (${cost} ${amount}).`,
    cheaper: (count, leastWrong, share) =>
      `Runs that are cheaper: ${count}, all of them wrong; the least wrong is ${leastWrong}, in ${share} of the pixels.`,
    safe: 'It decides as exact arithmetic would: it is right in every scene.',
    safer: (run, times) =>
      `Its arithmetic rounds: what is right here may be wrong elsewhere. Right in every scene, and the cheapest of that kind, is ${run}, at ${times} the cost.`,
    others: (runs) => `The cheapest right runs of the other methods, beside it: ${runs}.`,
    neverRight: (methods) => `Right under no kernel: ${methods}.`,
  },
  operations: {
    windows: (share) => `${share} of its operations take a window from the stack`,
    boxes: (share) => `${share} of its operations are box tests`,
    depths: (share) => `${share} of its operations are depths of planes`,
    orientations: (share) => `${share} of its operations are orientation tests`,
    comparisons: (share) => `${share} of its operations are comparisons of depths`,
    intersections: (share) => `${share} of its operations are intersections`,
    rows: (share) => `${share} of its operations look for the ends of rows`,
    edges: (share) => `${share} of its operations are steps of edges`,
  },
  replay: {
    title: 'The chosen run',
    hint: 'Click a point, or choose one by keyboard.',
    oneScene: 'Show a single scene to replay one of its runs.',
    replay: 'Replay this run',
    compare: 'Compare with the exact run',
    unlinked: {
      window: 'The page has no run that stops at larger windows.',
      large: 'The scene is too large for a link: open its file on the page.',
    },
  },
  empty: 'No chart is open.',
  howTo: 'This writes one, of each way to run these scenes:',
  unreadable: (name, where, reason) =>
    `${name} is not a chart that can be read. ${where === '' ? '' : `${where}: `}${reason}.`,
  broken: (name) => `${name} could not be read.`,
};
