import type { ChartTexts } from '../../language/chart-texts.js';

export const costs: ChartTexts['costs'] = {
  time: {
    name: 'Time',
    axis: 'time, relative to the fastest run',
    ratioAxis: 'time, relative to the fastest run',
    sentence: (rounds) =>
      `Time is that of a picture without a trace, the median of ${rounds} rounds, relative to the fastest run.`,
    ratioSentence:
      'Time is relative to the fastest run of each picture: the geometric mean over the pictures.',
  },
  operations: {
    name: 'Operations',
    axis: 'operations',
    ratioAxis: 'operations, relative to the fewest',
    sentence: () => 'Operations are the elementary steps of the listings.',
    ratioSentence:
      'Operations are relative to the fewest of each picture: the geometric mean over the pictures.',
  },
  bits: {
    name: 'Bits',
    axis: 'operations × bits',
    ratioAxis: 'operations × bits, relative to the fewest',
    sentence: () => 'Bits are the operations times the bits of the numbers that they are made on.',
    ratioSentence:
      'Bits, operations times the bits of their numbers, are relative to the fewest of each picture: the geometric mean over the pictures.',
  },
  samples: {
    name: 'Samples',
    axis: 'samples',
    ratioAxis: 'samples, relative to the fewest',
    sentence: () => 'Samples are those that all curves have together.',
    ratioSentence:
      'Samples are relative to the fewest of each picture: the geometric mean over the pictures.',
  },
};

export const errors: ChartTexts['errors'] = {
  wrongPixels: {
    name: 'Wrong pixels',
    axis: 'wrong pixels, of all',
    sentence: 'Wrong pixels differ from the picture rule.',
    meanSentence: 'Wrong pixels differ from the picture rule: the mean share over the pictures.',
  },
  area: {
    name: 'Area',
    axis: 'area of difference, of all',
    sentence: 'The area is that by which the picture differs from the visible regions.',
    meanSentence:
      'The area is that by which the picture differs from the visible regions: the mean share over the pictures.',
  },
  wrongDecisions: {
    name: 'Wrong decisions',
    axis: 'wrong decisions, of all',
    sentence: 'Wrong decisions differ from exact arithmetic.',
    meanSentence: 'Wrong decisions differ from exact arithmetic: the mean share over the pictures.',
  },
  depthUlps: {
    name: 'Depth',
    axis: 'farthest depth, ulps',
    sentence: 'Depth is how far a computed one is from the polygon’s plane at most, in ulps.',
    meanSentence:
      'Depth is how far a computed one is from the polygon’s plane at most, in ulps: the farthest in any of the pictures.',
  },
  wrongColumns: {
    name: 'Wrong columns',
    axis: 'wrong columns, of all',
    sentence:
      'Wrong columns are those over which a curve is drawn and should be hidden, or the other way round.',
    meanSentence:
      'Wrong columns are those over which a curve is drawn and should be hidden, or the other way round: the mean share over the pictures.',
  },
  height: {
    name: 'Height missed',
    axis: 'height missed, px',
    sentence:
      'Height missed is how far a curve is from the function at most, over any of its columns.',
    meanSentence:
      'Height missed is how far a curve is from the function at most, over any of its columns: the farthest in any of the pictures.',
  },
};
