import { methodRules, prefixed, variantTitles } from '../../language/family-texts.js';
import type { FamilyTexts } from '../../language/family-texts.js';

const names = variantTitles('ru');

export const family: FamilyTexts = {
  names,
  methods: prefixed('Варнок: ', names),
  rules: methodRules('ru'),
  purposes: {
    Relation: 'как многоугольник расположен относительно окна?',
    TrialFunction: 'пересекает ли окно хотя бы одно ребро многоугольника?',
    RayCrossings: 'сколько раз луч из центра окна пересекает контур?',
    OctantAngles: 'на какой угол контур поворачивает вокруг окна?',
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
