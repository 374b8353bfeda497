import { methodRules, prefixed, variantTitles } from '../../language/family-texts.js';
import type { FamilyTexts } from '../../language/family-texts.js';

const names = variantTitles('ru');

export const family: FamilyTexts = {
  names,
  methods: prefixed('Варнок: ', names),
  rules: methodRules('ru'),
  panel: {
    level: 'уровень',
    third: 'Третий',
    surrounding: 'Охватывающие',
    outside: 'Внешние',
    sinceLevel: (level) => `с уровня ${level}`,
    hides: 'закрывает',
    ray: 'луч n',
    octants: 'октанты S',
  },
};
