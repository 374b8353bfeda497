import { methodRules, prefixed, variantTitles } from '../../language/family.js';
import type { FamilyTexts } from '../../language/texts.js';

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
