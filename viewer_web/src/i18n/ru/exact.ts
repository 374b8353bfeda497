import type { Answer } from '../../trace/values.js';
import type { ExactTexts } from '../exact-texts.js';

const answer = (value: Answer): string => {
  if (typeof value === 'boolean') return value ? 'да' : 'нет';
  if (typeof value === 'number') return String(value).replace('-', '−');
  const [first, end] = value;
  if (end - first === 1) return String(first);
  return first < end ? `от ${first} до ${end - 1}` : 'пусто';
};

const ulps = (n: number): string => `${n > 0 ? '+' : n < 0 ? '−' : ''}${Math.abs(n)}`;

export const exact: ExactTexts = {
  exactness: 'Точно?',
  decided: {
    comparison: 'сравнение двух чисел',
    orientation: 'сторона прямой',
    nearer: 'сравнение глубин',
    outside: 'лежит ли рамка вне окна',
    inside: 'лежит ли рамка внутри окна',
    first_centre: 'первый пиксель',
    last_centre: 'последний пиксель',
    rows: 'строки',
    columns: 'столбцы',
    same_rounded: 'одинаково ли округляются два числа',
    pixel: 'пиксель, в который попадает число',
    visibility: 'признак видимости',
    left_of: 'лежит ли точка слева от ребра',
    parallel: 'параллельны ли прямые или плоскости',
  },
  causes: {
    rounded: 'Ошибка округления в этой операции.',
    drifted: 'Для своих операндов верно: погрешность накоплена раньше.',
  },
  answer,
  computed: 'Вычислено',
  exact: 'Точно',
  decidedBy: 'Чем решено',
  stages: {
    given: 'координатами, как они заданы',
    scene: 'оценкой погрешности для всей сцены',
    operands: 'оценкой погрешности этих чисел',
    exact: 'точной арифметикой',
  },
  right: 'Верно.',
  wrong: 'Неверно.',
  undefined: 'После неверной ветви верного ответа здесь нет.',
  unchecked: 'Этот прогон не сверен с точной арифметикой.',
  certain: 'С этими числами каждое решение точно.',
  check: 'Сверить все решения',
  nothing:
    'На этом шаге нет числового решения. Перейдите к знаку, сравнению или диапазону; «Перейти: неверное решение» находит неверные.',
  lens: (at) => `То же решение вокруг ${at}`,
  apart: (ulp) => `Клетка — соседнее число, шаг ${ulp}.`,
  noLens:
    'Карты этого решения нет: она бывает у знака и у сравнения глубин двух многоугольников, но не при всех видах чисел.',
  drawing: 'Спрашиваем у каждого соседа…',
  wrongPlaces: (wrong, all) =>
    wrong === 0 ? `Верно во всех ${all} местах.` : `Неверно в ${wrong} из ${all} мест.`,
  drifted:
    'На карте обе глубины вычислены по плоскостям. В прогоне ответ другой: глубина накоплена сложением вдоль строки.',
  cell: (x, y, computed, exactly) =>
    `x ${ulps(x)}, y ${ulps(y)} ulp: ${computed}, точно ${exactly}`,
  signs: { '-1': 'минус', 0: 'ноль', 1: 'плюс' },
  yesNo: { '-1': 'нет', 0: 'нет', 1: 'да' },
  pale: 'бледное — верно',
  dark: 'тёмное — неверно',
};
