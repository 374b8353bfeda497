import type { Bilingual } from '../language/language.js';
import type { SentencesOf } from '../language/texts.js';
import { agrees, capital, cells, listed } from '../language/words.js';
import type { Words } from '../language/words.js';
import type { Event, WarnockEvents } from '../trace/events.js';
import type { N } from '../trace/values.js';
import { containment, hidingOf, onlyOf, ownersOf, placeOf, sideAlong } from './naming.js';
import type { SideLine } from './naming.js';

const lists = {
  en: { surrounding: 'surrounding', outside: 'outside' },
  ru: { surrounding: 'охватывающих', outside: 'внешних' },
};

const found = {
  en: { surrounding: 'surround', outside: 'lie outside' },
  ru: { surrounding: 'охватывающим', outside: 'внешним' },
};

const rows = {
  en: { one: 'row', other: 'rows' },
  ru: { one: 'строке', other: 'строках' },
};

const vertices = {
  en: { one: 'vertex', other: 'vertices' },
  ru: { one: 'вершина', few: 'вершины', other: 'вершин' },
};

const colorOf = {
  en: (event: Event<'fill'>, words: Words): string => {
    const { polygons, background } = ownersOf(event, words.after, words.header);
    if (polygons.length === 0) return background ? 'the background' : `the colour ${event.color}`;
    if (polygons.length === 1 && !background) return `the colour of ${polygons.join('')}`;
    return `the colour that ${listed([...polygons, ...(background ? ['the background'] : [])], 'and')} share`;
  },
  ru: (event: Event<'fill'>, words: Words): string => {
    const { polygons, background } = ownersOf(event, words.after, words.header);
    if (polygons.length === 0) return background ? 'цвет фона' : `цвет ${event.color}`;
    if (polygons.length === 1 && !background) return `цвет ${polygons.join('')}`;
    return `общий цвет ${listed([...polygons, ...(background ? ['фона'] : [])], 'и')}`;
  },
};

const place = (at: readonly (number | string)[], words: Words): string => {
  const corner = placeOf(at, words);
  return corner === null ? `point ${words.point(at)}` : `${corner} corner`;
};

const itsList = (ids: string): string => (ids === '' ? 'его список пуст' : `его список: ${ids}`);

const currentList = (words: Words): string =>
  words.ids((words.after.warnock?.apl?.entries ?? []).map(([id]) => id));

/** The name of a point whose side of an edge is determined, with its corner of the window if it is one. */
const sideOf: Bilingual<
  Readonly<Record<SideLine, (at: readonly N[], corner: string | null, words: Words) => string>>
> = {
  en: {
    TF2: (at, corner, words) =>
      `The ${corner === null ? `point ${words.point(at)}` : `${corner} corner`}`,
    CR4: () => 'The centre of the window, where the ray begins,',
    OA4: (at, corner, words) =>
      `The ${corner === null ? `point ${words.point(at)}` : `${corner} corner`} of the window`,
    BF1: () => 'The next vertex',
  },
  ru: {
    TF2: (at, corner, words) =>
      corner === null ? `Точка ${words.point(at)}` : `Угол окна (${corner})`,
    CR4: () => 'Центр окна, начало луча,',
    OA4: (at, corner, words) =>
      corner === null ? `Точка ${words.point(at)}` : `Угол окна (${corner})`,
    BF1: () => 'Следующая вершина',
  },
};

const inCorner: Readonly<Record<string, string>> = {
  'левый верхний': 'в левом верхнем углу',
  'левый нижний': 'в левом нижнем углу',
  'правый верхний': 'в правом верхнем углу',
  'правый нижний': 'в правом нижнем углу',
};

const where = (at: readonly (number | string)[], words: Words): string =>
  inCorner[placeOf(at, words) ?? ''] ?? `в точке ${words.point(at)}`;

const sides = { top: 'верхняя', left: 'левая', bottom: 'нижняя', right: 'правая' } as const;

export const sentences: SentencesOf<keyof WarnockEvents | 'depth'> = {
  depth: {
    en: ({ at: line, polygon, point: at, z }, words) =>
      `At the ${place(at, words)} ${line === 'PC3' ? polygon : `the plane of ${polygon}`} has depth ${words.short(z)}.`,
    ru: ({ at: line, polygon, point: at, z }, words) =>
      `${capital(where(at, words))} глубина ${line === 'PC3' ? '' : 'плоскости '}${polygon} равна ${words.short(z)}.`,
  },
  push: {
    en: ({ at, window, shared, apl }, words) => {
      if (at === 'W3' || at === 'WS1' || at === 'WF1') {
        return `The first window, ${words.windowText(window)}, goes on the stack with ${words.ids((apl ?? []).map(([id]) => id)) || 'no polygon'}.`;
      }
      if (at === 'WF12') return `The part ${words.windowText(window)} goes on the stack.`;
      const list = shared === true ? 'the same list' : 'its own copy of the list';
      return `The part ${words.windowText(window)} goes on the stack with ${list}.`;
    },
    ru: ({ at, window, shared, apl }, words) => {
      if (at === 'W3' || at === 'WS1' || at === 'WF1') {
        return `Первое окно ${words.windowText(window)} кладётся в стек, ${itsList(words.ids((apl ?? []).map(([id]) => id)))}.`;
      }
      if (at === 'WF12') return `Часть ${words.windowText(window)} кладётся в стек.`;
      const list = shared === true ? 'с тем же списком' : 'с собственной копией списка';
      return `Часть ${words.windowText(window)} кладётся в стек ${list}.`;
    },
  },
  skip: {
    en: ({ window }, { windowText }) =>
      `The part ${windowText(window)} lies outside the area: it is skipped.`,
    ru: ({ window }, { windowText }) =>
      `Часть ${windowText(window)} лежит вне области: она пропускается.`,
  },
  pop: {
    en: ({ at, window }, words) => {
      const taken = `The window ${words.windowText(window)} comes off the stack`;
      if (at === 'WF2') {
        return `${taken}: it is of level ${words.after.warnock?.way?.length ?? 0}.`;
      }
      if (words.header.detail === 'windows') return `${taken}.`;
      return `${taken} with ${currentList(words) || 'an empty list'}.`;
    },
    ru: ({ at, window }, words) => {
      const taken = `Окно ${words.windowText(window)} берётся из стека`;
      if (at === 'WF2') return `${taken}, его уровень ${words.after.warnock?.way?.length ?? 0}.`;
      if (words.header.detail === 'windows') return `${taken}.`;
      return `${taken}, ${itsList(currentList(words))}.`;
    },
  },
  corners: {
    en: ({ z }, { short }) =>
      `Nothing is seen yet: the depth at all four corners starts at ${short(z)}.`,
    ru: ({ z }, { short }) =>
      `Пока ничего не видно: глубина во всех четырёх углах равна ${short(z)}.`,
  },
  box: {
    en: ({ polygon, outside }) =>
      outside
        ? `The box of ${polygon} lies outside the window.`
        : `The box of ${polygon} meets the window.`,
    ru: ({ polygon, outside }) =>
      outside
        ? `Габаритный прямоугольник ${polygon} лежит вне окна.`
        : `Габаритный прямоугольник ${polygon} пересекается с окном.`,
  },
  discard: {
    en: ({ polygon }) => `${polygon} is not counted in this window: it leaves the list.`,
    ru: ({ polygon }) => `${polygon} в этом окне не учитывается: он удаляется из списка.`,
  },
  count: {
    en: ({ polygon, count }) =>
      `${polygon} is counted in this window: polygonCount is now ${count}.`,
    ru: ({ polygon, count }) => `${polygon} учитывается в этом окне: polygonCount теперь ${count}.`,
  },
  compare: {
    en: ({ polygon, corner, z, against, nearer }, words) => {
      const where = corner === undefined ? 'At the point' : `At the ${words.places([corner])}`;
      const [own, other] = words.shortApart(z, against);
      const so = nearer ? 'nearer' : 'not nearer';
      return agrees(nearer, z, against)
        ? `${where} ${polygon} is ${so}: ${own} ${nearer ? '>' : '≯'} ${other}.`
        : `${where} ${polygon} counts as ${so}: ${own} against ${other}.`;
    },
    ru: ({ polygon, corner, z, against, nearer }, words) => {
      const place =
        corner === undefined ? 'В точке' : capital(inCorner[words.places([corner])] ?? '');
      const [own, other] = words.shortApart(z, against);
      const so = nearer ? 'ближе' : 'не ближе';
      return agrees(nearer, z, against)
        ? `${place} ${polygon} ${so}: ${own} ${nearer ? '>' : '≯'} ${other}.`
        : `${place} ${polygon} считается ${so}: ${own} против ${other}.`;
    },
  },
  nearer: {
    en: ({ polygon, corners, k }, words) => {
      if (k === 0) return `${polygon} is nearer at none of the 4 corners.`;
      const where = k === 4 ? '' : ` (${words.places(corners)})`;
      return `${polygon} is nearer at ${k} of 4 corners${where}.`;
    },
    ru: ({ polygon, corners, k }, words) => {
      if (k === 0) return `${polygon} не ближе ни в одном из 4 углов.`;
      const list = k === 4 ? '' : ` (${words.places(corners)})`;
      return `${polygon} ближе в ${k} из 4 углов${list}.`;
    },
  },
  uncover: {
    en: ({ polygon }, { before }) => {
      const hidden = before.warnock?.covering ?? null;
      return hidden === null
        ? `${polygon} is nearer somewhere: for now nothing is known to hide everything.`
        : `${polygon} is nearer somewhere, so ${hidden} no longer hides everything.`;
    },
    ru: ({ polygon }, { before }) => {
      const hidden = before.warnock?.covering ?? null;
      return hidden === null
        ? `${polygon} где-то ближе: пока неизвестно, закрывает ли один из многоугольников остальные.`
        : `${polygon} где-то ближе, и ${hidden} больше не закрывает всего.`;
    },
  },
  surround: {
    en: ({ polygon, point: at, inside }, words) =>
      `The ${place(at, words)} lies ${inside ? 'in' : 'outside'} ${polygon}.`,
    ru: ({ polygon, point: at, inside }, words) => {
      const corner = placeOf(at, words);
      const subject = corner === null ? `Точка ${words.point(at)}` : `${capital(corner)} угол`;
      return `${subject} лежит ${inside ? 'в' : 'вне'} ${polygon}.`;
    },
  },
  mark: {
    en: ({ polygon }) => `All four corners lie in ${polygon}: it surrounds the window.`,
    ru: ({ polygon }) => `Все четыре угла лежат в ${polygon}: он охватывает окно.`,
  },
  cover: {
    en: ({ polygon }) =>
      `${polygon} surrounds the window and is nearest at all four corners: it hides all so far.`,
    ru: ({ polygon }) =>
      `${polygon} охватывает окно и ближе всех в четырёх углах: он закрывает всё рассмотренное.`,
  },
  insider: {
    en: ({ at, polygon, inside }) =>
      at === 'RE2'
        ? `The box of ${polygon} ${inside ? 'lies' : 'does not lie'} strictly inside the window.`
        : inside
          ? `The box of ${polygon}, the first that is counted, lies strictly inside the window.`
          : `The box of ${polygon}, the first that is counted, does not lie strictly inside the window.`,
    ru: ({ at, polygon, inside }) =>
      at === 'RE2'
        ? `Габаритный прямоугольник ${polygon} ${inside ? 'лежит' : 'не лежит'} строго внутри окна.`
        : inside
          ? `Габаритный прямоугольник ${polygon}, первого из учтённых, лежит строго внутри окна.`
          : `Габаритный прямоугольник ${polygon}, первого из учтённых, не лежит строго внутри окна.`,
  },
  summary: {
    en: ({ count, hasSurround }, words) => {
      const found = words.counted(count, { one: 'polygon', other: 'polygons' });
      const one = words.after.warnock?.covering ?? 'one';
      return `${found} counted in the window; ${hasSurround ? `${one} hides all others` : 'none is known to hide the others'}.`;
    },
    ru: ({ count, hasSurround }, words) => {
      const one = words.after.warnock?.covering ?? 'один из них';
      return `Учтено многоугольников в окне: ${count}; ${hasSurround ? `${one} закрывает остальные` : 'неизвестно, закрывает ли один из них остальные'}.`;
    },
  },
  decide: {
    en: (event, { after }) => {
      const only = onlyOf(after);
      const covering = hidingOf(after) ?? 'One polygon';
      return {
        empty: 'No polygon is left in the window: it takes the background.',
        surrounded: `${covering} hides everything: the window takes its colour.`,
        pixel: 'The window is no larger than a pixel: the point at its centre decides.',
        single: `Only ${only ?? 'one polygon'} is left in the window: background first, then ${only ?? 'the polygon'}.`,
        split: 'None of the simple cases: the window is split.',
      }[event.case];
    },
    ru: (event, { after }) => {
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
  },
  fill: {
    en: (event, words) =>
      `${words.takes(event.rect[2] * event.rect[3])} ${colorOf.en(event, words)}.`,
    ru: (event, words) =>
      `${words.takes(event.rect[2] * event.rect[3])} ${colorOf.ru(event, words)}.`,
  },
  nearest: {
    en: ({ polygon, z }, { short }) =>
      `${polygon} is the nearest at the point so far: z = ${short(z)}.`,
    ru: ({ polygon, z }, { short }) => `Пока в этой точке ближе всех ${polygon}: z = ${short(z)}.`,
  },
  color: {
    en: (event, words) => {
      const { polygons, background } = ownersOf(event, words.after, words.header);
      const seen = polygons.join(' or ') || (background ? 'the background' : event.color);
      return `At ${words.point(event.point)} the viewer sees ${seen}.`;
    },
    ru: (event, words) => {
      const { polygons, background } = ownersOf(event, words.after, words.header);
      const seen = polygons.join(' или ') || (background ? 'фон' : event.color);
      return `В точке ${words.point(event.point)} виден ${seen}.`;
    },
  },
  orient: {
    en: ({ at, polygon, edge, point: where, value, sign }, words) => {
      const name = at === 'S2' || at === 'S3' || at === 'ED3' ? null : sideOf.en[at];
      const what = name === null ? 'The point' : name(where, placeOf(where, words), words);
      const side = {
        '-1': 'on the negative side of',
        0: 'on the line of',
        1: 'on the positive side of',
      };
      return `${what} lies ${side[sign]} edge ${edge} of ${polygon} (${words.short(value)}).`;
    },
    ru: ({ at, polygon, edge, point: place, value, sign }, words) => {
      const name = at === 'S2' || at === 'S3' || at === 'ED3' ? null : sideOf.ru[at];
      const what = name === null ? 'Точка' : name(place, placeOf(place, words), words);
      const side = {
        '-1': 'по отрицательную сторону ребра',
        0: 'на прямой ребра',
        1: 'по положительную сторону ребра',
      }[sign];
      return `${what} лежит ${side} ${edge} многоугольника ${polygon} (${words.short(value)}).`;
    },
  },
  clip_begin: {
    en: ({ polygon }) => `${polygon} is clipped by the window’s four sides in turn.`,
    ru: ({ polygon }) => `${polygon} отсекается по очереди четырьмя сторонами окна.`,
  },
  clip_side: {
    en: (event, { after, point }) => {
      const along = sideAlong(event, after.warnock?.window ?? null);
      const which = along === null ? '' : `, the ${along} one`;
      return `Side ${event.side} of 4${which}, from ${point(event.from)} to ${point(event.to)}: the new list is empty.`;
    },
    ru: (event, { after, point }) => {
      const along = sideAlong(event, after.warnock?.window ?? null);
      const which = along === null ? '' : `, ${sides[along]}`;
      return `Сторона ${event.side} из 4${which}, от ${point(event.from)} до ${point(event.to)}: новый список пуст.`;
    },
  },
  clip_sign: {
    en: ({ vertex, sign }, { point }) => {
      const where = {
        '-1': 'on the negative side of this line and counts as inside',
        0: 'on this line and counts as inside',
        1: 'on the positive side of this line and counts as outside',
      }[sign];
      return `The vertex ${point(vertex.slice(0, 2))} lies ${where}.`;
    },
    ru: ({ vertex, sign }, { point }) => {
      const place = {
        '-1': 'по отрицательную сторону этой прямой и считается внутренней',
        0: 'на этой прямой и считается внутренней',
        1: 'по положительную сторону этой прямой и считается внешней',
      }[sign];
      return `Вершина ${point(vertex.slice(0, 2))} лежит ${place}.`;
    },
  },
  clip_cross: {
    en: ({ vertex }, { point }) =>
      `The edge crosses the side at ${point(vertex.slice(0, 2))}: the crossing joins the new list.`,
    ru: ({ vertex }, { point }) =>
      `Ребро пересекает сторону в точке ${point(vertex.slice(0, 2))}: эта точка входит в новый список.`,
  },
  clip_keep: {
    en: ({ vertex }, { point }) => `The vertex ${point(vertex.slice(0, 2))} joins the new list.`,
    ru: ({ vertex }, { point }) => `Вершина ${point(vertex.slice(0, 2))} входит в новый список.`,
  },
  clip_drop: {
    en: ({ vertex }, { point }) =>
      `The vertex ${point(vertex.slice(0, 2))} counts as outside and is dropped.`,
    ru: ({ vertex }, { point }) =>
      `Вершина ${point(vertex.slice(0, 2))} считается внешней и отбрасывается.`,
  },
  clip_list: {
    en: ({ count }, words) =>
      count === 0
        ? 'Nothing is left.'
        : `This side is done: ${words.counted(count, vertices.en)} in the list.`,
    ru: ({ count }, words) =>
      count === 0
        ? 'Ничего не осталось.'
        : `Сторона пройдена: в списке ${words.counted(count, vertices.ru)}.`,
  },
  clip_result: {
    en: ({ polygon, vertices: left }, words) =>
      left.length === 0
        ? `Clipping leaves nothing of ${polygon}.`
        : `Clipping leaves a part of ${polygon} with ${words.counted(left.length, vertices.en)}.`,
    ru: ({ polygon, vertices: left }, words) =>
      left.length === 0
        ? `После отсечения от ${polygon} ничего не осталось.`
        : `После отсечения от ${polygon} осталась часть: ${words.counted(left.length, vertices.ru)}.`,
  },
  row: {
    en: ({ row, left, right, first, end }, { after, columnsOf, short }) => {
      const met = onlyOf(after) ?? 'the polygon';
      const where = first < end ? columnsOf(first, end - 1) : 'no pixel’s centre';
      return `Row ${short(row)} meets ${met} from ${short(left)} to ${short(right)}: ${where}.`;
    },
    ru: ({ row, left, right, first, end }, { after, columnsOf, short }) => {
      const met = onlyOf(after) ?? 'многоугольник';
      const where = first < end ? columnsOf(first, end - 1) : 'ни одного центра пикселя';
      return `Строка ${short(row)} пересекает ${met} от ${short(left)} до ${short(right)}: ${where}.`;
    },
  },
  draw: {
    en: ({ polygon, runs }, words) =>
      runs.length === 0
        ? `No pixel takes the colour of ${polygon}: no centre lies in this part of it.`
        : `${words.takes(cells(runs))} the colour of ${polygon} in ${words.counted(runs.length, rows.en)}.`,
    ru: ({ polygon, runs }, words) =>
      runs.length === 0
        ? `Ни один пиксель не получает цвет ${polygon}: в этой его части нет ни одного центра.`
        : `${words.takes(cells(runs))} цвет ${polygon} в ${words.counted(runs.length, rows.ru)}.`,
  },

  back_face: {
    en: ({ polygon, away }) =>
      away
        ? `${polygon} runs clockwise: it looks away from the viewer and does not take part.`
        : `${polygon} runs counter-clockwise: it looks towards the viewer and takes part.`,
    ru: ({ polygon, away }) =>
      away
        ? `${polygon} обходится по часовой стрелке: это нелицевая грань, и она не участвует.`
        : `${polygon} обходится против часовой стрелки: это лицевая грань, и она участвует.`,
  },
  rejoin: {
    en: ({ polygon, list, level }) =>
      `${polygon} was found to ${found.en[list]} a window of level ${level}, and this window is not part of that one: it goes back to the third list.`,
    ru: ({ polygon, list, level }) =>
      `${polygon} признан ${found.ru[list]} для окна уровня ${level}, а это окно — не его часть: он возвращается в третий список.`,
  },
  join: {
    en: ({ polygon, list, level }) =>
      `${polygon} joins the ${lists.en[list]} polygons at level ${level}: this relation holds for all parts of this window.`,
    ru: ({ polygon, list, level }) =>
      `${polygon} входит в список ${lists.ru[list]}, уровень ${level}: так будет и для всех частей этого окна.`,
  },
  relation: {
    en: ({ polygon, relation }) =>
      ({
        outside: `${polygon} lies outside the window.`,
        inside: `${polygon} lies wholly inside the window.`,
        intersecting: `${polygon} intersects the window: an edge meets it.`,
        surrounding: `${polygon} surrounds the window.`,
      })[relation],
    ru: ({ polygon, relation }) =>
      ({
        outside: `${polygon} лежит вне окна.`,
        inside: `${polygon} лежит целиком внутри окна.`,
        intersecting: `${polygon} пересекает окно: через окно проходит ребро.`,
        surrounding: `${polygon} охватывает окно.`,
      })[relation],
  },
  trial: {
    en: ({ polygon, edge, meets }) =>
      `Edge ${edge} of ${polygon} ${meets ? 'meets' : 'does not meet'} the window.`,
    ru: ({ polygon, edge, meets }) =>
      `Ребро ${edge} многоугольника ${polygon} ${meets ? 'пересекает' : 'не пересекает'} окно.`,
  },
  meets: {
    en: ({ polygon, meets }) =>
      meets
        ? `An edge of ${polygon} meets the window.`
        : `No edge of ${polygon} meets the window: it surrounds the window, or lies outside.`,
    ru: ({ polygon, meets }) =>
      meets
        ? `Одно из рёбер ${polygon} пересекает окно.`
        : `Ни одно ребро ${polygon} не пересекает окна: он охватывает окно или лежит вне его.`,
  },
  ray: {
    en: ({ at, edge, counts }, { after, header }) => {
      const so = `${containment(after.warnock)} so far`;
      if (at === 'CR4') {
        return counts === 1
          ? `Edge ${edge} crosses the ray: ${so}.`
          : `Edge ${edge} passes to the left of where the ray begins: ${so}.`;
      }
      if (counts > 0 && header.edition === 'vertex-counted-twice') {
        return `The beginning of edge ${edge} lies on the ray: touching or piercing, it counts as two here; ${so}.`;
      }
      const where = `The beginning of edge ${edge} lies on the ray, where the outline`;
      if (counts === 2) return `${where} touches it, which counts as two: ${so}.`;
      if (counts === 1) return `${where} pierces it, which counts as one: ${so}.`;
      return `The beginning of edge ${edge} lies to the left of where the ray begins: ${so}.`;
    },
    ru: ({ at, edge, counts }, { after, header }) => {
      const so = `пока ${containment(after.warnock)}`;
      if (at === 'CR4') {
        return counts === 1
          ? `Ребро ${edge} пересекает луч: ${so}.`
          : `Ребро ${edge} проходит левее начала луча: ${so}.`;
      }
      if (counts > 0 && header.edition === 'vertex-counted-twice') {
        return `Начало ребра ${edge} лежит на луче: и касание, и протыкание здесь считаются за два: ${so}.`;
      }
      const where = `Начало ребра ${edge} лежит на луче. Контур там`;
      if (counts === 2) return `${where} касается луча: это два пересечения, ${so}.`;
      if (counts === 1) return `${where} протыкает луч: это одно пересечение, ${so}.`;
      return `Начало ребра ${edge} лежит левее начала луча: ${so}.`;
    },
  },
  crossings: {
    en: ({ polygon, count }, words) =>
      `The outline of ${polygon} crosses the ray ${words.counted(count, { one: 'time', other: 'times' })}: ${count % 2 === 1 ? 'odd, so it surrounds the window' : 'even, so it lies outside'}.`,
    ru: ({ polygon, count }, words) =>
      `Контур ${polygon} пересекает луч ${words.counted(count, { one: 'раз', few: 'раза', other: 'раз' })}: ${count % 2 === 1 ? 'число нечётное, поэтому он охватывает окно' : 'число чётное, поэтому он лежит вне окна'}.`,
  },
  octants: {
    en: ({ at, edge, from, to, difference }, { after, signed }) => {
      const way = `Edge ${edge} goes from octant ${from} to octant ${to}`;
      const sum = signed(containment(after.warnock));
      return at === 'OA4'
        ? `${way}, the opposite one: split by a side of the window, it turns by ${signed(difference)}; the sum is ${sum}.`
        : `${way}: ${signed(difference)}; the sum is ${sum}.`;
    },
    ru: ({ at, edge, from, to, difference }, { after, signed }) => {
      const way = `Ребро ${edge} идёт из октанта ${from} в октант ${to}`;
      const sum = signed(containment(after.warnock));
      return at === 'OA4'
        ? `${way}, противоположный: разбитое стороной окна, оно даёт ${signed(difference)}; сумма ${sum}.`
        : `${way}: ${signed(difference)}; сумма ${sum}.`;
    },
  },
  angle: {
    en: ({ polygon, octants }, { signed }) =>
      octants === 0
        ? `The turns of ${polygon} cancel: the sum is 0 octants, so it lies outside the window.`
        : `${polygon} runs around the window: the sum is ${signed(octants)} octants, so it surrounds the window.`,
    ru: ({ polygon, octants }, { signed }) =>
      octants === 0
        ? `Повороты ${polygon} взаимно уничтожаются: сумма 0 октантов, поэтому он лежит вне окна.`
        : `${polygon} обходит окно кругом: сумма ${signed(octants)} октантов, поэтому он охватывает окно.`,
  },
  hiding: {
    en: ({ polygon }) =>
      polygon === undefined
        ? 'No surrounding polygon is known to hide all others.'
        : `${polygon} surrounds the window and lies in front of all others: it hides them.`,
    ru: ({ polygon }) =>
      polygon === undefined
        ? 'Неизвестно, закрывает ли охватывающий многоугольник все остальные.'
        : `${polygon} охватывает окно и лежит впереди всех: он закрывает остальные.`,
  },
  split_vertex: {
    en: ({ polygon, vertex, column, row, splits }, { short }) =>
      splits
        ? `Vertex ${vertex} of ${polygon} lies in the window, which is split next to it, at x = ${short(column)}, y = ${short(row)}.`
        : `Vertex ${vertex} of ${polygon} lies in the window, but next to it, at x = ${short(column)}, y = ${short(row)}, there is nothing to split.`,
    ru: ({ polygon, vertex, column, row, splits }, { short }) =>
      splits
        ? `Вершина ${vertex} многоугольника ${polygon} лежит в окне: оно делится рядом с ней, x = ${short(column)}, y = ${short(row)}.`
        : `Вершина ${vertex} многоугольника ${polygon} лежит в окне, но рядом с ней, x = ${short(column)}, y = ${short(row)}, делить нечего.`,
  },
  edge_depth: {
    en: ({ polygon, edge, z }, { short }) =>
      `${polygon} is seen edge-on; its edge ${edge} has depth ${short(z)} at the point.`,
    ru: ({ polygon, edge, z }, { short }) =>
      `${polygon} виден с ребра; глубина его ребра ${edge} в этой точке равна ${short(z)}.`,
  },
};
