import type { AtlasTexts } from '../../language/atlas-texts.js';

export const atlas: AtlasTexts = {
  title: 'Atlas of failures',
  open: 'Atlas of failures',
  close: 'Close',
  show: 'Show',
  all: 'all',
  kinds: {
    rounding: 'rounding',
    printed: 'errors of the printed text',
    mistake: 'usual mistakes',
    limit: 'limits of a method',
    test: 'without a scene',
  },
  noScene: 'no scene can show it',
  remedy: 'Remedy',
  at: (step, there) => `Step ${step}: ${there}`,
  goTo: 'Go to the step',
  compare: 'Compare with the remedy',
  leave: 'Leave the comparison',
  forget: 'Hide',
};
