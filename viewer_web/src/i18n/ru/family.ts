import { methodRules, prefixed, variantTitles } from '../family-texts.js';
import type { FamilyTexts } from '../family-texts.js';
import { containment } from '../words.js';
import { point, short, signed } from './numbers.js';

const lists = { surrounding: 'охватывающих', outside: 'внешних' } as const;
const found = { surrounding: 'охватывающим', outside: 'внешним' } as const;

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
  sentences: {
    back_face: ({ polygon, away }) =>
      away
        ? `${polygon} обходится по часовой стрелке: он отвёрнут от наблюдателя и не участвует.`
        : `${polygon} обходится против часовой стрелки: он обращён к наблюдателю и участвует.`,
    rejoin: ({ polygon, list, level }) =>
      `${polygon} признан ${found[list]} в окне уровня ${level}, а это окно — не его часть: он возвращается в третий список.`,
    join: ({ polygon, list, level }) =>
      `${polygon} входит в список ${lists[list]}, уровень ${level}: так будет и для всех частей этого окна.`,
    relation: ({ polygon, relation }) =>
      ({
        outside: `${polygon} лежит вне окна.`,
        inside: `${polygon} лежит целиком внутри окна.`,
        intersecting: `${polygon} пересекает окно: его встречает ребро.`,
        surrounding: `${polygon} охватывает окно.`,
      })[relation],
    trial: ({ polygon, edge, meets }) =>
      `Ребро ${edge} многоугольника ${polygon} ${meets ? 'встречает' : 'не встречает'} окно.`,
    meets: ({ polygon, meets }) =>
      meets
        ? `Одно из рёбер ${polygon} встречает окно.`
        : `Ни одно ребро ${polygon} не встречает окна: он охватывает окно или лежит вне его.`,
    ray: ({ at, edge, counts }, { after, header }) => {
      const so = `пока ${containment(after.warnock)}`;
      if (at === 'CR4') {
        return counts === 1
          ? `Ребро ${edge} пересекает луч: ${so}.`
          : `Ребро ${edge} проходит левее начала луча: ${so}.`;
      }
      if (counts > 0 && header.edition === 'vertex-counted-twice') {
        return `Начало ребра ${edge} лежит на луче: касание и протыкание здесь считаются за два: ${so}.`;
      }
      const where = `Начало ребра ${edge} лежит на луче, граница там`;
      if (counts === 2) return `${where} касается его, это считается за два: ${so}.`;
      if (counts === 1) return `${where} протыкает его, это считается за одно: ${so}.`;
      return `Начало ребра ${edge} лежит левее начала луча: ${so}.`;
    },
    crossings: ({ polygon, count }, words) =>
      `Граница ${polygon} пересекает луч ${words.counted(count, { one: 'раз', few: 'раза', other: 'раз' })}: ${count % 2 === 1 ? 'нечётно, он охватывает окно' : 'чётно, он лежит вне окна'}.`,
    octants: ({ at, edge, from, to, difference }, { after }) => {
      const way = `Ребро ${edge} идёт из октанта ${from} в октант ${to}`;
      const sum = signed(containment(after.warnock));
      return at === 'OA4'
        ? `${way}, противоположный: разбитое стороной окна, оно даёт ${signed(difference)}; сумма ${sum}.`
        : `${way}: ${signed(difference)}; сумма ${sum}.`;
    },
    angle: ({ polygon, octants }) =>
      octants === 0
        ? `Повороты ${polygon} уничтожаются: сумма 0 октантов, он лежит вне окна.`
        : `${polygon} обходит окно кругом: сумма ${signed(octants)} октантов, он охватывает окно.`,
    hiding: ({ polygon }) =>
      polygon === undefined
        ? 'Неизвестно, закрывает ли охватывающий многоугольник все остальные.'
        : `${polygon} охватывает окно и лежит впереди всех: он закрывает остальные.`,
    split_vertex: ({ polygon, vertex, column, row, splits }) =>
      splits
        ? `Вершина ${vertex} многоугольника ${polygon} лежит в окне: оно делится рядом с ней, x = ${short(column)}, y = ${short(row)}.`
        : `Вершина ${vertex} многоугольника ${polygon} лежит в окне, но рядом с ней, x = ${short(column)}, y = ${short(row)}, делить нечего.`,
    edge_depth: ({ polygon, edge, z }) =>
      `${polygon} повёрнут ребром; глубина его ребра ${edge} в этой точке равна ${short(z)}.`,
  },
  side: {
    TF2: (at, corner) => (corner === null ? `Точка ${point(at)}` : `Угол окна (${corner})`),
    CR4: () => 'Центр окна, начало луча,',
    OA4: (at, corner) => (corner === null ? `Точка ${point(at)}` : `Угол окна (${corner})`),
    BF1: () => 'Следующая вершина',
  },
};
