export const costs = {
  time: {
    name: 'Time',
    /** The label of the axis, for a single subject and for means. */
    axis: 'time, relative to the fastest run',
    ratioAxis: 'time, relative to the fastest run',
    sentence: (rounds: string): string =>
      `Time to draw the picture without a trace: the median of ${rounds} rounds, relative to the fastest run.`,
    ratioSentence:
      'Time is relative to the fastest run of each picture: the geometric mean over the pictures.',
  },
  operations: {
    name: 'Operations',
    /** The label of the axis, for a single subject and for means. */
    axis: 'operations',
    ratioAxis: 'operations, relative to the fewest',
    sentence: (): string => 'Operations are the elementary steps of the listings.',
    ratioSentence:
      'Operations are relative to the fewest of each picture: the geometric mean over the pictures.',
  },
  bits: {
    name: 'Bits',
    /** The label of the axis, for a single subject and for means. */
    axis: 'operations × bits',
    ratioAxis: 'operations × bits, relative to the fewest',
    sentence: (): string => 'Bits: the number of operations times the width of their numbers.',
    ratioSentence:
      'Bits (operations times the width of their numbers) are relative to the fewest of each picture: the geometric mean over the pictures.',
  },
  samples: {
    name: 'Samples',
    /** The label of the axis, for a single subject and for means. */
    axis: 'samples',
    ratioAxis: 'samples, relative to the fewest',
    sentence: (): string => 'Samples: the total over all curves.',
    ratioSentence:
      'Samples are relative to the fewest of each picture: the geometric mean over the pictures.',
  },
};

export const errors = {
  wrongPixels: {
    name: 'Wrong pixels',
    axis: 'wrong pixels, of all',
    sentence: 'Wrong pixels differ from the picture rule.',
    meanSentence: 'Wrong pixels differ from the picture rule: the mean share over the pictures.',
  },
  area: {
    name: 'Area',
    axis: 'area of difference, of all',
    sentence: 'Area: the part of the picture that differs from the visible regions.',
    meanSentence:
      'Area: the part of the picture that differs from the visible regions, as the mean share over the pictures.',
  },
  wrongDecisions: {
    name: 'Wrong decisions',
    axis: 'wrong decisions, of all',
    sentence: 'Wrong decisions differ from exact arithmetic.',
    meanSentence: 'Wrong decisions differ from exact arithmetic: the mean share over the pictures.',
  },
  depthUlps: {
    name: 'Depth',
    axis: 'largest depth error, ulps',
    sentence: 'Depth: the largest error of a computed depth against the polygon’s plane, in ulps.',
    meanSentence:
      'Depth: the largest error of a computed depth against the polygon’s plane, in ulps, over all pictures.',
  },
  wrongColumns: {
    name: 'Wrong columns',
    axis: 'wrong columns, of all',
    sentence: 'Wrong columns: a curve is drawn there and should be hidden, or the other way round.',
    meanSentence:
      'Wrong columns: a curve is drawn there and should be hidden, or the other way round. The mean share over the pictures.',
  },
  height: {
    name: 'Height missed',
    axis: 'height missed, px',
    sentence:
      'Height missed: the largest distance between a curve and the function over its columns.',
    meanSentence:
      'Height missed: the largest distance between a curve and the function over its columns, over all pictures.',
  },
};
