import { counted } from '../../language/words.js';
import type { PluralForms } from '../../language/words.js';

const rules = new Intl.PluralRules('en');
const count = (n: number, forms: PluralForms): string => counted(n, forms, rules);

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

export const verdict = {
  /** Begins the result. */
  finished: 'Finished',
  welcome: 'Finished: where polygons overlap, the nearest is visible. Play to see how.',
  pixels: (n: number): string => count(n, { one: 'pixel', other: 'pixels' }),
  allRight: 'all as in exact arithmetic',
  /** Replaces it where polygons share a colour, so that a right colour may be that of a wrong polygon. */
  allColorsRight: 'all colours as in exact arithmetic',
  someWrong: (n: number): string =>
    `${count(n, { one: 'differs', other: 'differ' })} from exact arithmetic`,
  /** Replaces it for a text that is not the corrected one: its arithmetic may be right. */
  someOther: (n: number): string =>
    `${count(n, { one: 'differs', other: 'differ' })} from the correct picture`,
  comparing: 'being compared with exact arithmetic…',
  notCompared: 'not compared with exact arithmetic',
  decisionsRight: 'every decision as in exact arithmetic',
  /** Replaces it for a text that is not the corrected one: its picture may be wrong nevertheless. */
  decisionsRightBut: 'every decision as in exact arithmetic, but this is not the corrected text',
  /** The number of steps. */
  decisionsWrong: (n: number): string =>
    `wrong decisions at ${count(n, { one: 'step', other: 'steps' })}`,
  windows: (n: number): string => count(n, { one: 'window', other: 'windows' }),
  comparisons: (n: number): string =>
    count(n, { one: 'depth comparison', other: 'depth comparisons' }),
  regions: (n: number): string => count(n, { one: 'visible region', other: 'visible regions' }),
  curves: (n: number): string => count(n, { one: 'curve', other: 'curves' }),
};

export const tour = {
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
