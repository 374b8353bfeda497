import type { Flag } from '../../floating-horizon/events.js';
import { isLostBelow, isPoint, metBy } from '../../replay/sides.js';
import type { CurveSentences, CurveTexts } from '../../language/curve-texts.js';
import { rangeOf } from '../../language/words.js';
import { point, short, shortApart } from './numbers.js';

const columns = { one: 'столбцом', other: 'столбцами' };

const where = ([left, right]: readonly [number, number]): string =>
  left === right
    ? `над столбцом ${short(left)}`
    : `между столбцами ${short(left)} и ${short(right)}`;

const names = { upper: 'с верхним горизонтом', lower: 'с нижним горизонтом' } as const;

const flags: Readonly<Record<`${Flag}`, string>> = {
  1: 'на верхнем горизонте или выше него: видна (1)',
  '-1': 'на нижнем горизонте или ниже него: видна (−1)',
  0: 'строго между горизонтами: не видна (0)',
  2: 'на обоих горизонтах, или их ещё нет: видна (2)',
};

/** Между двумя такими точками напечатанный текст ничего не рисует (X-H1). */
const lostBelow = 'на нижнем горизонте или ниже него (−1)';

export const curveSentences: CurveSentences = {
  horizons: ({ upper, lower }) =>
    upper === undefined || lower === undefined
      ? 'Ни над одним столбцом горизонта ещё нет.'
      : `Над каждым столбцом верхний горизонт начинается с ${short(upper)}, нижний — с ${short(lower)}.`,
  curve: ({ curve }) =>
    curve === 0 ? 'Первая кривая, 0, ближе всех.' : `Следующая кривая — ${curve}.`,
  side_edge: ({ at, sample }) =>
    `${at === 'FH3' ? 'Левое' : 'Правое'} боковое ребро дошло до ${point(sample)}.`,
  visibility: ({ x, flag }, { after, header }) => {
    const told = after.horizon?.told ?? null;
    const at = told?.x === x ? ` на высоте ${short(told.y)}` : '';
    const isLost = isLostBelow(flag, header.edition);
    return `Над столбцом ${short(x)} кривая${at} — ${isLost ? lostBelow : flags[flag]}.`;
  },
  intersection: ({ at, point: met, columns: between }, { after }) => {
    const horizon = metBy(at, after.horizon ?? null);
    return `Отрезок встречается ${horizon === null ? 'с горизонтом' : names[horizon]} в ${point(met)}, ${where(between)}.`;
  },
  draw_line: (event) => {
    const { at, from, to } = event;
    if (isPoint(event)) return `Кривая видна в точке ${point(from)}.`;
    const why = {
      FH6: 'весь путь она на одной стороне',
      FH7: 'дальше её закрывает горизонт, или она переходит на другую сторону',
      FH8: 'до того её закрывал горизонт, или она была на другой стороне',
    }[at];
    return `Кривая рисуется от ${point(from)} до ${point(to)}: ${why}.`;
  },
  horizon: ({ first, last, upper, lower }, words) => {
    if (last < first) return 'Между ними нет ни одного столбца: горизонты прежние.';
    const over = first === last ? `Столбец ${short(first)}` : `Столбцы ${rangeOf(first, last)}`;
    if (upper.length + lower.length === 0) return `${over}: оба горизонта прежние.`;
    const raised = `верхний горизонт поднимается над ${words.counted(upper.length, columns)}`;
    const lowered = `нижний горизонт опускается над ${words.counted(lower.length, columns)}`;
    if (lower.length === 0) return `${over}: ${raised}.`;
    return upper.length === 0 ? `${over}: ${lowered}.` : `${over}: ${raised}, ${lowered}.`;
  },
  height: ({ x, y, upper, lower }) => {
    if (upper === undefined || lower === undefined) {
      return `Над столбцом ${short(x)} кривая на высоте ${short(y)}; горизонта там нет.`;
    }
    const [own, above] = shortApart(y, upper);
    const [, below] = shortApart(y, lower);
    return `Над столбцом ${short(x)} кривая на высоте ${own}; верхний горизонт на ${above}, нижний на ${below}.`;
  },
  raise: ({ x, y }) => `Над столбцом ${short(x)} верхний горизонт теперь на ${short(y)}.`,
  lower: ({ x, y }) => `Над столбцом ${short(x)} нижний горизонт теперь на ${short(y)}.`,
  step: ({ x, changes }) =>
    changes
      ? `Над столбцом ${short(x)} отрезок по другую сторону горизонта: встреча на пути сюда.`
      : `Над столбцом ${short(x)} отрезок по ту же сторону горизонта.`,
};

export const curves: CurveTexts = {
  curve: (curve) => `Кривая ${curve}`,
  inHand: 'кривая',
  segment: 'отрезок',
  edges: 'Боковые рёбра',
  left: 'левое',
  right: 'правое',
  column: 'столбец',
  upper: 'верхний',
  lower: 'нижний',
  looked: 'признак',
  lines: 'линий',
  flags: {
    above: '1, выше',
    below: '−1, ниже',
    hidden: '0, скрыта',
    both: '2, обе',
  },
  layers: {
    lines: 'линии',
    curve: 'текущая кривая',
    horizons: 'горизонты',
    columns: 'признаки столбцов',
    edges: 'боковые рёбра',
  },
  layersName: 'Что показано на изображении',
  around: (column) => `Горизонты около столбца ${column}`,
  history: {
    pixel: 'Столбец',
    at: (x) => `Столбец ${x}`,
    hint: (key) =>
      `Щёлкните по столбцу изображения${key === null ? '' : ` или нажмите ${key}`}: здесь будут все кривые над ним, каждый признак и каждое изменение горизонтов.`,
    how: 'Стрелки влево и вправо — другой столбец, с Shift — через десять. Enter показывает историю столбца. Escape — выход.',
    forget: 'Забыть столбец',
    entries: 'Всё, что было над столбцом',
    outcomes: { pass: 'видна', fail: 'не видна', paint: 'нарисована', wrong: 'неверно', note: '' },
    painted: (step) => `Линия над ним на шаге ${step}`,
    unpainted: 'Ни одна линия над ним не проходит.',
  },
  surface: {
    own: 'Поверхность y = f(x, z)…',
    name: 'Поверхность',
    how: 'Тяните отсчёт текущей кривой вверх или вниз; с клавиатуры — стрелками вверх и вниз. Или меняйте функцию.',
    title: 'Поверхность',
    function: 'y как функция от x и z',
    language:
      'x, z, pi; + − * / ^, сравнения, ? :; sin, cos, tan, asin, acos, atan, atan2, sinh …, exp, ln, log2, log10, sqrt, abs, sign, min, max, sum, avg.',
    sampled: (curves, samples) =>
      `Кривых ${curves}, отсчётов ${samples}, заданы числами. Сдвинутые отсчёты заменяют функцию.`,
    give: 'Задать функцию',
    ends: { x: ['x слева', 'x справа'], z: ['z вблизи', 'z вдали'] },
    curves: 'кривых',
    samples: 'отсчётов',
    tolerance: 'допуск',
    toleranceHint:
      'В пикселях: где кривая отходит дальше от прямой между отсчётами, посередине ставится ещё один. Пусто: без этого',
    up: 'пикс. вверх',
    ways: {
      origin: 'Левый конец ближайшей кривой при y = 0',
      across: 'От левого конца кривой к правому',
      back: 'От кривой к следующей',
    },
    place: ['столбцы', 'строки'],
    sample: (curve, x, y) => `Кривая ${curve}, столбец ${x}: высота ${y}`,
  },
};
