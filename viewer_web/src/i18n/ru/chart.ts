import type { ChartTexts } from '../../language/texts.js';
import { methodTitles } from '../../language/family.js';
import { costs, errors } from './chart-axes.js';
import { subjects } from './chart-subjects.js';
import { family } from './family.js';

export const chart: ChartTexts = {
  question: 'Чего стоит верное изображение?',
  ownFile: 'Свой график',
  openFile: 'Открыть файл…',
  dropHere: 'или перетащите его сюда: .json',
  subjects,
  kinds: { ordinary: 'Обычные', degenerate: 'Вырожденные', surfaces: 'Поверхности' },
  allOf: {
    ordinary: (count) => `Все обычные сцены (${count})`,
    degenerate: (count) => `Все вырожденные сцены (${count})`,
    surfaces: (count) => `Все поверхности (${count})`,
  },
  aboutScene: (pixels, polygons, unsteady) =>
    `пикселей: ${pixels} · многоугольников: ${polygons} · пикселей, зависящих от одного ulp: ${unsteady}`,
  aboutSurface: (curves, columns) =>
    `кривых: ${curves} · столбцов у всех кривых: ${columns} · только цена рисования, без цены отсчётов`,
  cost: 'Цена',
  error: 'Ошибка',
  add: 'Добавить',
  nothingMore: 'ничего',
  right: 'верно',
  wrong: 'неверно',
  cheapestMark: 'самый дешёвый верный',
  methods: {
    ...methodTitles('ru'),
    warnock: 'Варнок',
    ...family.methods,
  },
  variants: 'Варианты алгоритма Варнока',
  variantNames: family.names,
  knobs: {
    bits: 'биты',
    depth: 'биты глубины',
    grid: 'сетка',
    window: 'окно',
    samples: 'отсчёты',
    tolerance: 'допуск',
  },
  turned: {
    bits: (value) => `арифметика, бит: ${value}`,
    depth: (value) => `Z-буфер, бит: ${value}`,
    grid: (value) => `субпиксельная сетка, бит: ${value}`,
    window: (value) => `наименьшее окно, пикселей: ${value}`,
    samples: (value) => `отсчётов на кривую:\u00a0${value}`,
    tolerance: (value) => `допуск ${value}\u00a0пикс.`,
  },
  editions: { printed: 'как напечатано' },
  fault: 'прерван ошибкой',
  printed: 'напечатанный текст',
  costs,
  errors,
  counted: (part, all) => `${part} из ${all}`,
  units: { depthUlps: (count) => `${count} ulp`, height: (count) => `${count} пикс.` },
  about: 'Что отложено по осям',
  reading:
    'Левее — дешевле. Над чертой изображение неверно: чем выше, тем хуже; под чертой оно верно.',
  missing: (kernels) => `Не показаны, так как у их чисел нет постоянной разрядности: ${kernels}.`,
  plot: (cost, error) => `${error}, ${cost}`,
  keys: 'Клавиши: ← → по цене, ↑ ↓ по ошибке, Home, End; Esc закрывает.',
  front: 'граница: дешевле и не хуже ничего нет',
  table: 'Точки таблицей',
  run: 'Прогон',
  whichRun: 'Какой прогон выбрать',
  advice: {
    cheapest: 'Дешевле всех верных здесь',
    safe: 'Дешевле всех верных везде',
    wrong: 'Ещё дешевле, но неверно',
    same: (run) =>
      `${run} — самый дешёвый верный прогон, и он верен везде: его решения те же, что в точной арифметике.`,
    safer: (run, times) =>
      `${run} — самый дешёвый верный прогон; верный не только здесь, но и везде обойдётся дороже: ×${times}.`,
    unsafe: (run) =>
      `${run} — самый дешёвый верный прогон; у прогонов, верных везде, такой цены нет.`,
  },
  noRun: 'нет',
  panel: {
    title: 'Выбранный прогон',
    hint: 'Щёлкните по точке или выберите её с клавиатуры.',
    own: 'Его изображение',
    right: 'Точное изображение',
    replay: 'Воспроизвести этот прогон',
    compare: 'Сравнить с точным',
    unlinked: {
      window: 'На странице нет прогона, который останавливается на окнах крупнее пикселя.',
      large: 'Файл слишком велик для ссылки: откройте его на странице.',
    },
  },
  empty: 'График не открыт.',
  howTo: 'Эта команда строит его для всех способов выполнения этих сцен:',
  unreadable: (name, where, reason) =>
    `Файл ${name} нельзя прочитать как график. ${where === '' ? '' : `${where}: `}${reason}.`,
  broken: (name) => `Файл ${name} не удалось прочитать.`,
};
