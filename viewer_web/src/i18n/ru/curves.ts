import type { CurveTexts } from '../../language/texts.js';
import { short } from './numbers.js';

export const curves: CurveTexts = {
  curve: (curve) => `Кривая ${curve}`,
  current: 'кривая',
  segment: 'отрезок',
  edges: 'Боковые рёбра',
  left: 'левое',
  right: 'правое',
  column: 'столбец',
  upper: 'верхний',
  lower: 'нижний',
  looked: 'флаг',
  lines: 'линий',
  flags: {
    above: '1, выше',
    below: '−1, ниже',
    hidden: '0, скрыта',
    both: '2, оба',
  },
  layers: {
    lines: 'линии',
    curve: 'текущая кривая',
    horizons: 'горизонты',
    columns: 'флаги столбцов',
    edges: 'боковые рёбра',
  },
  layersName: 'Что показано на изображении',
  around: (column) => `Горизонты около столбца ${column}`,
  history: {
    pixel: 'Столбец',
    at: (x) => `Столбец ${x}`,
    horizons: (upper, lower) =>
      `верхний горизонт ${upper === null ? 'не задан' : short(upper)}, нижний ${lower === null ? 'не задан' : short(lower)}`,
    hint: (key) =>
      `Щёлкните по столбцу изображения${key === null ? '' : ` или нажмите ${key}`}: здесь будут все кривые над ним, каждый флаг и каждое изменение горизонтов.`,
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
      `Кривых: ${curves}, отсчётов: ${samples}; они заданы числами. Сдвинутые отсчёты заменяют функцию.`,
    give: 'Задать функцию',
    ends: { x: ['x слева', 'x справа'], z: ['z вблизи', 'z вдали'] },
    curves: 'кривых',
    samples: 'отсчётов',
    tolerance: 'допуск',
    toleranceHint:
      'В пикселях. Там, где кривая отходит от прямой между отсчётами дальше, посередине ставится ещё один отсчёт. Пустое поле: без допуска',
    up: 'пикс. вверх',
    ways: {
      origin: 'Левый конец ближайшей кривой при y = 0',
      across: 'От левого конца кривой к правому',
      back: 'От кривой к следующей',
    },
    place: ['столбцы', 'строки'],
    sample: (curve, x, y) => `Кривая ${curve}, столбец ${x}: y = ${y}`,
  },
};
