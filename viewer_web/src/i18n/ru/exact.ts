import type { ExactTexts } from '../../language/texts.js';
import { causeWords, decisionWords } from '../../trace/event-table.js';
import type { Answer } from '../../trace/values.js';

const answer = (value: Answer): string => {
  if (typeof value === 'boolean') return value ? 'да' : 'нет';
  if (typeof value === 'number') return String(value).replace('-', '−');
  const [first, end] = value;
  if (end - first === 1) return String(first);
  return first < end ? `от ${first} до ${end - 1}` : 'пусто';
};

const ulps = (n: number): string => `${n > 0 ? '+' : n < 0 ? '−' : ''}${Math.abs(n)}`;

const sides = { top: 'верхнюю', left: 'левую', bottom: 'нижнюю', right: 'правую' } as const;
const corners = {
  'top-left': 'левый верхний',
  'top-right': 'правый верхний',
  'bottom-left': 'левый нижний',
  'bottom-right': 'правый нижний',
} as const;

export const exact: ExactTexts = {
  exactness: 'Точно?',
  decided: decisionWords.ru,
  causes: causeWords.ru,
  answer,
  computed: 'Вычислено',
  exact: 'Точно',
  unchecked: 'Не проверено: этот прогон не сверен с точной арифметикой.',
  notChecked: 'не проверено',
  checking: 'Проверяется каждое решение прогона…',
  checkingShort: 'проверка…',
  found: (wrong) =>
    wrong === 0
      ? 'Проверено: все решения прогона верны.'
      : `Проверено: число шагов с неверными решениями — ${wrong}.`,
  foundNoneBut:
    'Проверено: все решения — как в точной арифметике. Но это не исправленный текст, и изображение всё же может быть неверным.',
  unable: {
    otherRun:
      'Не проверено: библиотека выполняет эту сцену иначе. Трассу записала другая программа или другая версия.',
    notHere: 'Не проверено: с такими числами библиотека этот текст не выполняет.',
    tooLong: 'Не проверено: с проверкой прогон слишком длинен для этой страницы.',
    failed: 'Не проверено: библиотека не смогла выполнить эту сцену снова.',
  },
  check: 'Сверить все решения',
  findings: {
    title: 'Решения, на которые стоит взглянуть',
    count: (count) => `Решений: ${count}`,
    withNumbers: 'включая равные числа',
    within:
      'На этом уровне подробности видны не все эти решения. Знак ⊃ означает, что решение принято внутри указанного шага; чтобы увидеть его само, запишите трассу с уровнем signs.',
    more: 'Показать ещё',
    polygons: 'Много\u00ADугольники',
    columns: { step: 'Шаг', kind: 'Вид', ulps: 'До нуля, ulp' },
    kinds: { wrong: 'неверно', point: 'точка смещена', zero: 'точный нуль', narrow: 'на грани' },
    narrowBy: (ulps) => `на грани: не дальше ${ulps} ulp от нуля`,
    coincidences: {
      point_on_line: 'точка на прямой',
      equal_depths: 'равные глубины',
      parallel_lines: 'параллельные прямые',
      shared_points: 'общая точка',
      on_pixel_centre: 'в центре пикселя',
      box_on_window: 'габаритный прямоугольник касается окна',
      curve_on_horizon: 'кривая на горизонте',
      equal_numbers: 'равные числа',
    },
    pixels: (off) => `${off} пикс.`,
    gap: (computed, exactly) => `Разность: вычисленная ${computed}, точная ${exactly}`,
    decides: (pixels) => `Определяет пиксели ${pixels}`,
  },
  margin: {
    edge: (edge, at) => `ребро ${edge} через ${at}`,
    vertex: (side) => `вершина через ${sides[side]} сторону`,
    edgeAtCorner: (edge, corner) => `ребро ${edge} через ${corners[corner]} угол`,
  },
  nothing: 'На этом шаге нет числового решения. Перейдите к знаку, сравнению или диапазону.',
  findWrong: '«Перейти: неверное решение» находит неверные.',
  lens: (at) => `То же решение вокруг ${at}`,
  apart: (ulp) => `Клетка — соседнее число, шаг ${ulp}.`,
  noLens:
    'Карты этого решения нет: она есть у знака и у сравнения глубин двух многоугольников, но не для всех чисел.',
  drawing: 'Вычисляется для каждого соседнего числа…',
  wrongPlaces: (wrong, all) =>
    wrong === 0 ? `Неверных мест нет: проверено ${all}.` : `Неверных мест: ${wrong} из ${all}.`,
  drifted:
    'На карте обе глубины вычислены по плоскостям. В прогоне ответ другой: глубина накоплена сложением вдоль строки.',
  cell: (x, y, computed, exactly) =>
    `x ${ulps(x)}, y ${ulps(y)} ulp: вычислено ${computed}; точный ответ: ${exactly}`,
  signs: { '-1': 'минус', 0: 'нуль', 1: 'плюс' },
  yesNo: { '-1': 'нет', 0: 'нет', 1: 'да' },
  pale: 'бледное — верно',
  dark: 'тёмное — неверно',
};
