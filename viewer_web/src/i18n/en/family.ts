import { methodRules, prefixed, variantTitles } from '../../language/family.js';

const names = variantTitles('en');

export const family = {
  /** The short names among variants, and the full names among other methods. */
  names,
  methods: prefixed('Warnock: ', names),
  /** The input and the rule of each method. */
  rules: methodRules('en'),
  panel: {
    level: 'level',
    third: 'Third',
    surrounding: 'Surrounding',
    outside: 'Outside',
    sinceLevel: (level: number): string => `since level ${level}`,
    hides: 'hides all',
    ray: 'ray n',
    octants: 'octants S',
  },
};
