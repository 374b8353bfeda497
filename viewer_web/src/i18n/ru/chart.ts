import type { ChartTexts } from '../../language/texts.js';
import { methodTitles } from '../../language/family.js';
import { costs, errors } from './chart-axes.js';
import { subjects } from './chart-subjects.js';
import { family } from './family.js';

export const chart: ChartTexts = {
  tagline: 'чего стоит верное изображение',
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
  series: 'Показаны',
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
  samplings: {
    samples: 'отсчёты через равные промежутки',
    tolerance: 'отсчёты по допуску',
    fixed: 'отсчёты, заданные в файле',
  },
  editions: { corrected: 'исправленный', printed: 'как напечатано' },
  fault: 'прерван ошибкой',
  printed: 'напечатанный текст',
  printedLabel: (kernel) => `${kernel}, печ.`,
  costs,
  errors,
  counted: (part, all) => `${part} из ${all}`,
  units: { depthUlps: (count) => `${count} ulp`, height: (count) => `${count} пикс.` },
  reading:
    'Левее — дешевле, ниже — точнее. В полосах 0 и ∞ все прогоны одинаково верны или неверны: ряды разнесены лишь для того, чтобы их различать.',
  missing: (kernels) => `Не показаны, так как у их чисел нет постоянной разрядности: ${kernels}.`,
  rightPicture: (share) => `само верное изображение: ${share}`,
  plot: (cost, error) => `${error}, ${cost}`,
  keys: 'Клавиши: ← → по цене, ↑ ↓ по ошибке, Home, End; Esc закрывает.',
  front: 'Граница: нет другого прогона, который и не дороже, и не хуже',
  frontMark: 'граница',
  run: 'Прогон',
  whichRun: 'Какой прогон выбрать',
  losses: {
    nothing: 'Его кривые ни над одним столбцом не отходят от функции.',
    height: (pixels) => `Его кривые отходят от функции не больше чем на ${pixels}`,
    noDecision:
      'Ни один прогон исправленного текста не принимает неверных решений: погрешность вносят только отсчёты.',
    decisions: (kernels) =>
      `Погрешность вносят отсчёты и арифметика. Неверных решений в прогоне исправленного текста не больше: ${kernels}.`,
  },
  operations: {
    windows: (share) => `${share} операций — окна, взятые из стека`,
    boxes: (share) => `${share} операций — габаритные тесты`,
    depths: (share) => `${share} операций — глубины плоскостей`,
    orientations: (share) => `${share} операций — проверки ориентации`,
    comparisons: (share) => `${share} операций — сравнения глубин`,
    intersections: (share) => `${share} операций — пересечения`,
    rows: (share) => `${share} операций — поиск концов строк`,
    edges: (share) => `${share} операций — шаги рёбер`,
    visibilities: (share) => `${share} операций — сравнения кривой с горизонтами`,
    horizons: (share) => `${share} операций — обновления горизонта`,
    steps: (share) => `${share} операций — поиск пересечения`,
    crossings: (share) => `${share} операций — вычисления пересечения`,
  },
  replay: {
    title: 'Выбранный прогон',
    hint: 'Щёлкните по точке или выберите её с клавиатуры.',
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
