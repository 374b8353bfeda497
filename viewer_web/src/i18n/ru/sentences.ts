import type { Sentences } from '../texts.js';
import { cells, hidingOf, onlyOf } from '../words.js';
import { point, short, shortApart, windowText } from './numbers.js';
import type { Words } from '../words.js';
import { curveSentences } from './curves.js';
import { exact } from './exact.js';
import { family } from './family.js';
import { isOpenOutline } from '../../regions/events.js';
import { regionSentences } from './regions.js';
import { purposes } from './page.js';

const pixels = { one: 'пиксель', few: 'пикселя', other: 'пикселей' };
const rows = { one: 'строке', other: 'строках' };
const vertices = { one: 'вершина', few: 'вершины', other: 'вершин' };

const takes = (n: number, words: Words): string =>
  `${words.counted(n, pixels)} ${n % 10 === 1 && n % 100 !== 11 ? 'получает' : 'получают'}`;

const colorOf = (color: string, words: Words): string => {
  const owner = words.owner(color);
  return owner === null ? 'цвет фона' : `цвет ${owner}`;
};

const inCorner: Readonly<Record<string, string>> = {
  'левый верхний': 'в левом верхнем углу',
  'левый нижний': 'в левом нижнем углу',
  'правый верхний': 'в правом верхнем углу',
  'правый нижний': 'в правом нижнем углу',
};

const where = (at: readonly (number | string)[], words: Words): string =>
  inCorner[words.placeOf(at) ?? ''] ?? `в точке ${point(at)}`;

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** «1», «1 и 0», «2, 1 и 0». */
const allOf = (list: readonly number[]): string =>
  [list.slice(0, -1).join(', '), list.slice(-1).join()].filter(Boolean).join(' и ');

const edgesOf = (list: readonly number[]): string =>
  `${list.length === 1 ? 'Ребро' : 'Рёбра'} ${allOf(list)}`;

const currentList = (words: Words): string =>
  words.ids((words.after.warnock?.apl?.entries ?? []).map(([id]) => id));

const sides = ['верхняя', 'левая', 'нижняя', 'правая'];
const when = (next: number | string, before: string): string =>
  next === 'inf' ? '' : `; ${before} ${short(next)}`;

const { answer, causes, decided } = exact;

export const sentences: Sentences = {
  plane: ({ polygon, plane }) =>
    `Плоскость ${polygon}: a, b, c, d = ${plane.map(short).join('; ')}.`,
  call: ({ of }) => `Начинается ${of}: ${purposes[of]}`,
  depth: ({ at: line, polygon, point: at, z }, words) =>
    `${capital(where(at, words))} глубина ${line === 'PC3' ? '' : 'плоскости '}${polygon} равна ${short(z)}.`,
  fault: ({ at, reason, x, y }) => {
    if (isOpenOutline(at)) {
      return 'Из-за округления контур здесь не замыкается: незамкнутое отбрасывается, и алгоритм идёт дальше.';
    }
    return x === undefined || y === undefined
      ? `Напечатанный текст здесь ошибается: ${reason}. Прогон окончен.`
      : `Напечатанный текст здесь ошибается: ${reason}, пиксель (${x}; ${y}).`;
  },
  disagree: ({ of, taken, exact, cause }) =>
    `Неверно, ${decided[of]}: вычислено ${answer(taken)}, точно ${answer(exact)}. ${causes[cause]}`,

  push: ({ at, window, shared, apl }, words) => {
    if (at === 'W3' || at === 'WS1' || at === 'WF1') {
      return `Первое окно ${windowText(window)} кладётся в стек, его список: ${words.ids((apl ?? []).map(([id]) => id)) || 'пуст'}.`;
    }
    if (at === 'WF12') return `Часть ${windowText(window)} кладётся в стек.`;
    const list = shared === true ? 'с тем же списком' : 'с собственной копией списка';
    return `Часть ${windowText(window)} кладётся в стек ${list}.`;
  },
  skip: ({ window }) => `Часть ${windowText(window)} лежит вне области: она пропускается.`,
  pop: ({ at, window }, words) =>
    at === 'WF2'
      ? `Окно ${windowText(window)} берётся из стека, его уровень ${words.after.warnock?.way?.length ?? 0}.`
      : `Окно ${windowText(window)} берётся из стека, его список: ${currentList(words) || 'пуст'}.`,
  corners: ({ z }) => `Пока ничего не видно: глубина во всех четырёх углах равна ${short(z)}.`,
  box: ({ polygon, outside }) =>
    outside
      ? `Габаритный прямоугольник ${polygon} лежит вне окна.`
      : `Габаритный прямоугольник ${polygon} пересекается с окном.`,
  discard: ({ polygon }) => `${polygon} не может быть виден в этом окне: он удаляется из списка.`,
  count: ({ polygon, count }) =>
    `${polygon} может быть виден в окне: polygonCount теперь ${count}.`,
  compare: ({ polygon, corner, z, against, nearer }, words) => {
    const place =
      corner === undefined ? 'В точке' : capital(inCorner[words.places([corner])] ?? '');
    const so = nearer ? 'ближе' : 'не ближе';
    return `${place} ${polygon} ${so}: ${shortApart(z, against).join(nearer ? ' > ' : ' ≯ ')}.`;
  },
  nearer: ({ polygon, corners, k }, words) => {
    if (k === 0) return `${polygon} не ближе ни в одном из 4 углов.`;
    const list = k === 4 ? '' : ` (${words.places(corners)})`;
    return `${polygon} ближе в ${k} из 4 углов${list}.`;
  },
  uncover: ({ polygon }, { before }) => {
    const hidden = before.warnock?.covering ?? null;
    return hidden === null
      ? `${polygon} где-то ближе: пока неизвестно, закрывает ли что-нибудь остальное.`
      : `${polygon} где-то ближе, и ${hidden} больше не закрывает всего.`;
  },
  surround: ({ polygon, point: at, inside }, words) => {
    const corner = words.placeOf(at);
    const subject = corner === null ? `Точка ${point(at)}` : `${capital(corner)} угол`;
    return `${subject} лежит ${inside ? 'в' : 'вне'} ${polygon}.`;
  },
  mark: ({ polygon }) => `Все четыре угла лежат в ${polygon}: он охватывает окно.`,
  cover: ({ polygon }) =>
    `${polygon} охватывает окно и ближе всех в четырёх углах: он закрывает всё рассмотренное.`,
  insider: ({ at, polygon, inside }) =>
    at === 'RE2'
      ? `Габаритный прямоугольник ${polygon} ${inside ? 'лежит' : 'не лежит'} строго внутри окна.`
      : inside
        ? `${polygon}, первый в окне, лежит целиком внутри него.`
        : `${polygon}, первый в окне, не лежит целиком внутри него.`,
  summary: ({ count, hasSurround }, words) => {
    const found = words.counted(count, {
      one: 'многоугольник',
      few: 'многоугольника',
      other: 'многоугольников',
    });
    const one = words.after.warnock?.covering ?? 'один из них';
    return `В окне ${found}; ${hasSurround ? `${one} закрывает остальные` : 'неизвестно, закрывает ли один остальные'}.`;
  },
  decide: (event, { after }) => {
    const only = onlyOf(after);
    const covering = hidingOf(after) ?? 'Один многоугольник';
    return {
      empty: 'В окне не осталось многоугольников: оно получает цвет фона.',
      surrounded: `${covering} закрывает всё: окно получает его цвет.`,
      pixel: 'Окно не больше пикселя: решает точка в его центре.',
      single: `В окне только ${only ?? 'один многоугольник'}: сначала фон, затем ${only ?? 'он сам'}.`,
      split: 'Ни один из простых случаев не подходит: окно делится.',
    }[event.case];
  },
  fill: ({ rect, color }, words) => `${takes(rect[2] * rect[3], words)} ${colorOf(color, words)}.`,
  nearest: ({ polygon, z }) => `Пока ближе всех в точке ${polygon}: z = ${short(z)}.`,
  color: ({ point: at, color }, words) => {
    const owner = words.owner(color);
    return `В точке ${point(at)} виден ${owner ?? 'фон'}.`;
  },
  orient: ({ at, polygon, edge, point: place, value, sign }, words) => {
    const name = at === 'S2' || at === 'S3' || at === 'ED3' ? null : family.side[at];
    const what = name === null ? 'Точка' : name(place, words.placeOf(place));
    const side = {
      '-1': 'по отрицательную сторону ребра',
      0: 'на прямой ребра',
      1: 'по положительную сторону ребра',
    }[sign];
    return `${what} лежит ${side} ${edge} многоугольника ${polygon} (${short(value)}).`;
  },
  clip_begin: ({ polygon }) => `${polygon} отсекается по очереди четырьмя сторонами окна.`,
  clip_side: ({ side }) => `Сторона ${side} из 4, ${sides[side - 1] ?? ''}: новый список пуст.`,
  clip_sign: ({ vertex, sign }) => {
    const place = { '-1': 'внутри от', 0: 'на прямой', 1: 'снаружи от' }[sign];
    return `Вершина ${point(vertex.slice(0, 2))} лежит ${place} этой стороны.`;
  },
  clip_cross: ({ vertex }) =>
    `Ребро пересекает сторону в ${point(vertex.slice(0, 2))}: точка входит в новый список.`,
  clip_keep: ({ vertex }) => `Вершина ${point(vertex.slice(0, 2))} входит в новый список.`,
  clip_drop: ({ vertex }) => `Вершина ${point(vertex.slice(0, 2))} лежит снаружи и отбрасывается.`,
  clip_list: ({ count }, words) =>
    count === 0
      ? 'Ничего не осталось.'
      : `Сторона пройдена: в списке ${words.counted(count, vertices)}.`,
  clip_result: ({ polygon, vertices: left }, words) =>
    left.length === 0
      ? `В окне нет ни одной части ${polygon}.`
      : `У части ${polygon} в окне ${words.counted(left.length, vertices)}.`,
  row: ({ row, left, right, first, end }) =>
    first < end
      ? `Строка ${row} пересекает многоугольник от ${short(left)} до ${short(right)}: столбцы ${first}–${end - 1}.`
      : `Строка ${row} пересекает многоугольник от ${short(left)} до ${short(right)}: ни одного центра пикселя.`,
  draw: ({ polygon, runs }, words) =>
    `${takes(cells(runs), words)} цвет ${polygon} в ${words.counted(runs.length, rows)}.`,

  ...family.sentences,

  clear: ({ z }) => `Изображение заполнено фоном, каждая ячейка Z-буфера — значением ${short(z)}.`,
  polygon: ({ polygon }) => `Следующий многоугольник: ${polygon}. S и AEL пусты.`,
  edge: ({ edge, rows }) => {
    const [first, last] = rows ?? [];
    if (first === undefined || last === undefined) return `Ребро ${edge} входит в S.`;
    if (last < first) return `Ребро ${edge} входит в S; оно не пересекает центра ни одной строки.`;
    return `Ребро ${edge} входит в S: строки ${first}–${last}.`;
  },
  extent: ({ ymin, ymax }) => `Многоугольник простирается от y = ${short(ymin)} до ${short(ymax)}.`,
  scanline: ({ y, row }) => `Строка растра ${row}, y = ${short(y)}.`,
  ael_add: ({ edge, x, z, until }) =>
    `Ребро ${edge} начинается: входит в AEL с x = ${short(x)}, z = ${short(z)}, до ${short(until)}.`,
  horizontal: ({ edge }) => `Ребро ${edge} горизонтально: оно рисуется сразу и в AEL не входит.`,
  leave: ({ edges, next }) =>
    edges.length === 0
      ? 'Из S ничего не удаляется.'
      : `${edgesOf(edges)} ${edges.length === 1 ? 'удаляется' : 'удаляются'} из S${when(next, 'следующее начинается при y =')}.`,
  ael_sort: ({ edges, next }, words) =>
    edges.length === 0
      ? 'AEL пуст.'
      : `AEL слева направо: ${words.list(edges)}${when(next, 'следующее изменение при y =')}.`,
  line: ({ row, from, to }) =>
    `Строка ${row} от x = ${short(from[0])} (z = ${short(from[1])}) до x = ${short(to[0])} (z = ${short(to[1])}).`,
  miss: () => 'Отрезок лежит вне области: показывать нечего.',
  slope: ({ dz }) => `От пикселя к пикселю z меняется на ${short(dz)}.`,
  columns: ({ first, end, z }) =>
    first < end
      ? `Столбцы ${first}–${end - 1}: z = ${short(z)} в первом.`
      : 'Между концами нет ни одного центра пикселя.',
  pixel: ({ x, y, z, stored, shown }) => {
    const [depth, before] = shortApart(z, stored);
    return shown
      ? `Пиксель (${x}; ${y}): ${depth} ближе, чем ${before}, — он виден.`
      : `Пиксель (${x}; ${y}): ${depth} не ближе, чем ${before}, — он закрыт.`;
  },
  span: ({ row, runs }, words) =>
    cells(runs) === 0
      ? `В строке ${row} ничего не меняется.`
      : `${takes(cells(runs), words)} цвет ${words.after.zbuffer?.polygon ?? ''} в строке ${row}.`,
  ael_drop: ({ edges, next }) =>
    edges.length === 0
      ? 'Ни одно ребро здесь не заканчивается.'
      : `${edgesOf(edges)} ${edges.length === 1 ? 'заканчивается и удаляется' : 'заканчиваются и удаляются'} из AEL${when(next, 'следующее изменение при y =')}.`,
  ael_step: ({ edge, x, z }) => `Ребро ${edge} делает шаг: x = ${short(x)}, z = ${short(z)}.`,

  ...curveSentences,
  ...regionSentences,
};
