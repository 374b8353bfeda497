export const subjects = {
  scenes: {
    show: 'Scene',
    showOne: 'Show a single scene to replay one of its runs.',
    /** The name of a series without a knob. */
    fixed: 'float, double…',
    missingSomewhere: (runs: string): string =>
      `Not shown because some scenes have no number for them: ${runs}.`,
    noneRight: 'No run shown gets every pixel right.',
  },
  surfaces: {
    show: 'Surface',
    showOne: 'Show a single surface to replay one of its runs.',
    /** The name of a series without a knob. */
    fixed: 'as given',
    missingSomewhere: (runs: string): string =>
      `Not shown because some surfaces were not sampled that way: ${runs}.`,
    noneRight: 'No run shown draws every column right.',
  },
};
