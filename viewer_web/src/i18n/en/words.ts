import type { TourTexts, VerdictTexts, WordTexts } from '../../language/word-texts.js';
import { counted } from '../../language/words.js';
import type { PluralForms } from '../../language/words.js';

const rules = new Intl.PluralRules('en');
const count = (n: number, forms: PluralForms): string => counted(n, forms, rules);

export const words: WordTexts = {
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

export const verdict: VerdictTexts = {
  pixels: (n) => count(n, { one: 'pixel', other: 'pixels' }),
  allRight: 'all as in exact arithmetic',
  allColorsRight: 'all colours as in exact arithmetic',
  someWrong: (n) => `${count(n, { one: 'differs', other: 'differ' })} from exact arithmetic`,
  someOther: (n) => `${count(n, { one: 'differs', other: 'differ' })} from the correct picture`,
  comparing: 'being compared with exact arithmetic…',
  notCompared: 'not compared with exact arithmetic',
  decisionsRight: 'every decision as in exact arithmetic',
  decisionsRightBut: 'every decision as in exact arithmetic, but this is not the corrected text',
  decisionsWrong: (n) => `wrong decisions at ${count(n, { one: 'step', other: 'steps' })}`,
  windows: (n) => count(n, { one: 'window', other: 'windows' }),
  comparisons: (n) => count(n, { one: 'depth comparison', other: 'depth comparisons' }),
  regions: (n) => count(n, { one: 'visible region', other: 'visible regions' }),
  curves: (n) => count(n, { one: 'curve', other: 'curves' }),
};

export const tour: TourTexts = {
  about: 'vidno runs hidden-surface algorithms step by step.',
  offer: 'New here? Take the tour',
  again: 'Show me around',
  next: 'Next',
  done: 'Done',
  leave: 'Leave the tour',
  at: (n, of) => `${n} of ${of}`,
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
