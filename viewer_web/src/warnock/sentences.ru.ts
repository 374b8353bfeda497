import { point, short, shortApart, signed, windowText } from '../i18n/ru/numbers.js';
import { columnsOf, takes } from '../i18n/ru/phrases.js';
import type { Sentences } from '../language/texts.js';
import { capital, cells, listed } from '../language/words.js';
import type { Words } from '../language/words.js';
import type { Event, WarnockEvents } from '../trace/events.js';
import type { N } from '../trace/values.js';
import { containment, hidingOf, onlyOf, ownersOf, placeOf, sideAlong } from './naming.js';
import type { SideLine } from './naming.js';

const lists = { surrounding: 'охватывающих', outside: 'внешних' } as const;
const found = { surrounding: 'охватывающим', outside: 'внешним' } as const;

const rows = { one: 'строке', other: 'строках' };
const vertices = { one: 'вершина', few: 'вершины', other: 'вершин' };

const colorOf = (event: Event<'fill'>, words: Words): string => {
  const { polygons, background } = ownersOf(event, words.after, words.header);
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
  inCorner[placeOf(at, words) ?? ''] ?? `в точке ${point(at)}`;

const currentList = (words: Words): string =>
  words.ids((words.after.warnock?.apl?.entries ?? []).map(([id]) => id));

const sides = { top: 'верхняя', left: 'левая', bottom: 'нижняя', right: 'правая' } as const;

/** How a point is called whose side of an edge is asked for, with its corner of the window if it is one. */
const sideOf: Readonly<Record<SideLine, (at: readonly N[], corner: string | null) => string>> = {
  TF2: (at, corner) => (corner === null ? `Точка ${point(at)}` : `Угол окна (${corner})`),
  CR4: () => 'Центр окна, начало луча,',
  OA4: (at, corner) => (corner === null ? `Точка ${point(at)}` : `Угол окна (${corner})`),
  BF1: () => 'Следующая вершина',
};

export const sentences: Pick<Sentences, keyof WarnockEvents | 'depth'> = {
  depth: ({ at: line, polygon, point: at, z }, words) =>
    `${capital(where(at, words))} глубина ${line === 'PC3' ? '' : 'плоскости '}${polygon} равна ${short(z)}.`,
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
    const corner = placeOf(at, words);
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
    const { polygons, background } = ownersOf(event, words.after, words.header);
    const seen = polygons.join(' / ') || (background ? 'фон' : event.color);
    return `В точке ${point(event.point)} виден ${seen}.`;
  },
  orient: ({ at, polygon, edge, point: place, value, sign }, words) => {
    const name = at === 'S2' || at === 'S3' || at === 'ED3' ? null : sideOf[at];
    const what = name === null ? 'Точка' : name(place, placeOf(place, words));
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
  row: ({ row, left, right, first, end }, { after }) => {
    const met = onlyOf(after) ?? 'многоугольник';
    const where = first < end ? columnsOf(first, end - 1) : 'ни одного центра пикселя';
    return `Строка ${short(row)} пересекает ${met} от ${short(left)} до ${short(right)}: ${where}.`;
  },
  draw: ({ polygon, runs }, words) =>
    `${takes(cells(runs), words)} цвет ${polygon} в ${words.counted(runs.length, rows)}.`,

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
};
