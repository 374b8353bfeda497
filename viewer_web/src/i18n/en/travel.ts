import type { TravelTexts } from '../../language/texts.js';

export const travel: TravelTexts = {
  procedure: 'Procedure',
  over: 'Over the call',
  overBack: 'Back over the call',
  out: 'Out of the procedure, to its result',
  outBack: 'Back out of the procedure, before its call',
  goTo: 'Go to',
  next: 'The next one',
  previous: 'The previous one',
  goals: {
    split: 'a split of a window',
    ael: 'a change of the AEL',
    curve: 'a curve',
    crossing: 'an intersection',
    list: 'a list from the stack',
    region: 'a visible region',
    wrong: 'a wrong decision',
    pixel: 'a step of the chosen pixel',
    bookmark: 'a bookmark',
  },
  ofPolygon: 'a step of the polygon',
  noGoal: 'none',
};
