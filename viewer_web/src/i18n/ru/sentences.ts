import type { Event } from '../../trace/events.js';
import type { Sentences } from '../../language/texts.js';
import { capital, cells, hidingOf, listed, onlyOf, sideAlong } from '../../language/words.js';
import { list, point, short, shortApart, windowText } from './numbers.js';
import type { Words } from '../../language/words.js';
import { curveSentences } from './curves.js';
import { exact } from './exact.js';
import { family } from './family.js';
import { isOpenOutline } from '../../weiler-atherton/events.js';
import { regionSentences } from './regions.js';
import { purposes } from './page.js';
import { columnsOf, takes, zbufferSentences } from './zbuffer.js';

const rows = { one: 'строке', other: 'строках' };
const vertices = { one: 'вершина', few: 'вершины', other: 'вершин' };

const colorOf = (event: Event<'fill'>, words: Words): string => {
  const { polygons, background } = words.ownersOf(event);
  if (polygons.length === 0) return background ? 'цвет фона' : `цвет ${event.color}`;
  if (polygons.length === 1 && !background) return `цвет ${polygons.join('')}`;
  return `общий цвет ${listed([...polygons, ...(background ? ['фона'] : [])], 'и')}`;
};

const inCorner: Readonly<Record<string, string>> = {
  'левый верхний': 'в левом верхнем углу',
  'левый нижний': 'в левом нижнем углу',
  'правый верхний': 'в правом верхнем углу',
  'правый нижний': 'в правом нижнем углу',
};

const where = (at: readonly (number | string)[], words: Words): string =>
  inCorner[words.placeOf(at) ?? ''] ?? `в точке ${point(at)}`;

const currentList = (words: Words): string =>
  words.ids((words.after.warnock?.apl?.entries ?? []).map(([id]) => id));

const sides = { top: 'верхняя', left: 'левая', bottom: 'нижняя', right: 'правая' } as const;
const { answer, causes, decided } = exact;

export const sentences: Sentences = {
  plane: ({ polygon, plane }) => `Плоскость ${polygon}: a, b, c, d = ${list(plane)}.`,
  call: ({ of }) => `Начинается ${of}: ${purposes[of]}`,
  depth: ({ at: line, polygon, point: at, z }, words) =>
    `${capital(where(at, words))} глубина ${line === 'PC3' ? '' : 'плоскости '}${polygon} равна ${short(z)}.`,
  fault: ({ at, reason, x, y }) => {
    if (isOpenOutline(at)) {
      return 'Из-за округления контур здесь не замыкается: незамкнутое отбрасывается, и алгоритм идёт дальше.';
    }
    return x === undefined || y === undefined
      ? `Напечатанный текст здесь ошибается: ${reason}. Прогон окончен.`
      : `Напечатанный текст здесь ошибается: ${reason}, пиксель ${point([x, y])}.`;
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
  pop: ({ at, window }, words) => {
    const taken = `Окно ${windowText(window)} берётся из стека`;
    if (at === 'WF2') return `${taken}, его уровень ${words.after.warnock?.way?.length ?? 0}.`;
    if (words.header.detail === 'windows') return `${taken}.`;
    return `${taken}, его список: ${currentList(words) || 'пуст'}.`;
  },
  corners: ({ z }) => `Пока ничего не видно: глубина во всех четырёх углах равна ${short(z)}.`,
  box: ({ polygon, outside }) =>
    outside
      ? `Габаритный прямоугольник ${polygon} лежит вне окна.`
      : `Габаритный прямоугольник ${polygon} пересекается с окном.`,
  discard: ({ polygon }) => `${polygon} в этом окне не учитывается: он удаляется из списка.`,
  count: ({ polygon, count }) =>
    `${polygon} учитывается в этом окне: polygonCount теперь ${count}.`,
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
        ? `Габаритный прямоугольник ${polygon}, первого из учтённых, лежит строго внутри окна.`
        : `Габаритный прямоугольник ${polygon}, первого из учтённых, не лежит строго внутри окна.`,
  summary: ({ count, hasSurround }, words) => {
    const found = words.counted(count, {
      one: 'многоугольник',
      few: 'многоугольника',
      other: 'многоугольников',
    });
    const one = words.after.warnock?.covering ?? 'один из них';
    return `В окне учтено ${found}; ${hasSurround ? `${one} закрывает остальные` : 'неизвестно, закрывает ли один остальные'}.`;
  },
  decide: (event, { after }) => {
    const only = onlyOf(after);
    const covering = hidingOf(after) ?? 'Один многоугольник';
    return {
      empty: 'В окне не осталось многоугольников: оно получает цвет фона.',
      surrounded: `${covering} закрывает всё: окно получает его цвет.`,
      pixel: 'Окно не больше пикселя: решает точка в его центре.',
      single: `В окне остался только ${only ?? 'один многоугольник'}: сначала фон, затем ${only ?? 'он сам'}.`,
      split: 'Ни один из простых случаев не подходит: окно делится.',
    }[event.case];
  },
  fill: (event, words) =>
    `${takes(event.rect[2] * event.rect[3], words)} ${colorOf(event, words)}.`,
  nearest: ({ polygon, z }) => `Пока ближе всех в точке ${polygon}: z = ${short(z)}.`,
  color: (event, words) => {
    const { polygons, background } = words.ownersOf(event);
    const seen = polygons.join(' / ') || (background ? 'фон' : event.color);
    return `В точке ${point(event.point)} виден ${seen}.`;
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
  clip_side: (event, { after }) => {
    const along = sideAlong(event, after.warnock?.window ?? null);
    const which = along === null ? '' : `, ${sides[along]}`;
    return `Сторона ${event.side} из 4${which}: новый список пуст.`;
  },
  clip_sign: ({ vertex, sign }) => {
    const place = {
      '-1': 'по отрицательную сторону этой прямой и считается внутренней',
      0: 'на этой прямой и считается внутренней',
      1: 'по положительную сторону этой прямой и считается внешней',
    }[sign];
    return `Вершина ${point(vertex.slice(0, 2))} лежит ${place}.`;
  },
  clip_cross: ({ vertex }) =>
    `Ребро пересекает сторону в ${point(vertex.slice(0, 2))}: точка входит в новый список.`,
  clip_keep: ({ vertex }) => `Вершина ${point(vertex.slice(0, 2))} входит в новый список.`,
  clip_drop: ({ vertex }) =>
    `Вершина ${point(vertex.slice(0, 2))} считается внешней и отбрасывается.`,
  clip_list: ({ count }, words) =>
    count === 0
      ? 'Ничего не осталось.'
      : `Сторона пройдена: в списке ${words.counted(count, vertices)}.`,
  clip_result: ({ polygon, vertices: left }, words) =>
    left.length === 0
      ? `После отсечения от ${polygon} ничего не осталось.`
      : `После отсечения от ${polygon} осталась часть: ${words.counted(left.length, vertices)}.`,
  row: ({ at, row, left, right, first, end }, { after }) => {
    const met = at === 'PR1' ? 'область' : (onlyOf(after) ?? 'многоугольник');
    const where = first < end ? columnsOf(first, end - 1) : 'ни одного центра пикселя';
    return `Строка ${short(row)} пересекает ${met} от ${short(left)} до ${short(right)}: ${where}.`;
  },
  draw: ({ polygon, runs }, words) =>
    `${takes(cells(runs), words)} цвет ${polygon} в ${words.counted(runs.length, rows)}.`,

  ...family.sentences,

  ...zbufferSentences,
  ...curveSentences,
  ...regionSentences,
};
