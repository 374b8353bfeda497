export const words = {
  explain: 'What these words mean',
  editions: {
    corrected: 'The procedures of the course text, with its errors corrected.',
    printed: 'The procedures exactly as the course text prints them, errors included.',
    defects: 'The corrected procedures with some errors of the course text restored.',
    mistake: 'The corrected procedures with one usual mistake in them.',
  },
  details: {
    windows: 'The trace has only the main steps.',
    polygons: 'The trace shows what is done with each polygon.',
    signs: 'The trace has everything, down to the sign of each decision.',
  },
};

export const tour = {
  /** The finished picture, for a first visitor; only if it is right. */
  welcome: 'Finished: where polygons overlap, the nearest is visible. Play to see how.',
  /** What the page does, for a first visitor. */
  about:
    'vidno shows, step by step, how a program finds the surface that is visible at each pixel.',
  offer: 'New here? Take the tour',
  again: 'Show me around',
  next: 'Next',
  done: 'Done',
  leave: 'Leave the tour',
  at: (n: number, of: number): string => `${n} of ${of}`,
  steps: [
    {
      title: 'The picture',
      text: 'This is what the run has painted. Point at a pixel to read it; click it to see why it has its colour.',
    },
    {
      title: 'The run',
      text: 'Play it from the start, or step with the arrow keys. The sentence says what happened, and why.',
    },
    {
      title: 'The procedure',
      text: 'The current line is marked, with its values beside it.',
    },
    {
      title: 'The text',
      text: 'Blue dotted words lead to the step that they describe. The workbench shows everything known about a step.',
    },
  ],
};
