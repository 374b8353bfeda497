import { methodRules, prefixed, variantTitles } from '../../language/family-texts.js';
import type { FamilyTexts } from '../../language/family-texts.js';

const names = variantTitles('ru');

export const family: FamilyTexts = {
  names,
  methods: prefixed('Варнок: ', names),
  rules: methodRules('ru'),
  purposes: {
    Relation: 'как многоугольник лежит относительно окна?',
    TrialFunction: 'встречает ли окно хоть одно ребро многоугольника?',
    RayCrossings: 'сколько раз граница пересекает луч из центра окна?',
    OctantAngles: 'насколько граница обходит окно кругом?',
    HidingPolygon: 'лежит ли охватывающий многоугольник впереди всех?',
  },
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
