import { methodRules, prefixed, variantTitles } from '../../language/family-texts.js';
import type { FamilyTexts } from '../../language/family-texts.js';

const names = variantTitles('en');

export const family: FamilyTexts = {
  names,
  methods: prefixed('Warnock: ', names),
  rules: methodRules('en'),
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
