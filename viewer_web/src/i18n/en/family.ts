import { methodRules, prefixed, variantTitles } from '../../language/family-texts.js';
import type { FamilyTexts } from '../../language/family-texts.js';

const names = variantTitles('en');

export const family: FamilyTexts = {
  names,
  methods: prefixed('Warnock: ', names),
  rules: methodRules('en'),
  purposes: {
    Relation: 'what is the relation of the polygon to the window?',
    TrialFunction: 'does an edge of the polygon meet the window?',
    RayCrossings: 'how often does the outline cross a ray from the centre of the window?',
    OctantAngles: 'how far does the outline turn around the window?',
    HidingPolygon: 'does a surrounding polygon lie in front of all others?',
  },
  panel: {
    level: 'level',
    third: 'Third',
    surrounding: 'Surrounding',
    outside: 'Outside',
    sinceLevel: (level) => `since level ${level}`,
    hides: 'hides all',
    ray: 'ray n',
    octants: 'octants S',
  },
};
