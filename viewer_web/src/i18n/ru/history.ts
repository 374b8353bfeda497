import type { HistoryTexts } from '../../language/texts.js';
import { approximately } from '../../language/words.js';
import { short } from './numbers.js';

export const history: HistoryTexts = {
  pixel: 'Пиксель',
  at: (x, y) => `Пиксель (${x}; ${y})`,
  spoken: ([x, y], { color, owners: { polygons, background }, depth, isStored }) => {
    const owner = [...polygons, ...(background ? ['фон'] : [])].join(' или ');
    const painted = color === null ? ['ещё не закрашен'] : [owner, color].filter(Boolean);
    const depths =
      depth === null ? [] : [`глубина ${isStored ? short(depth) : approximately(short(depth))}`];
    return `Пиксель (${x}; ${y}): ${[...painted, ...depths].join(', ')}`;
  },
  hint: (key) =>
    `Щёлкните по пикселю изображения${key === null ? '' : ` или нажмите ${key}`}: здесь будет всё, что его касалось, и почему у него такой цвет.`,
  how: 'Стрелки — другой пиксель, с Shift — через десять. Enter показывает историю пикселя. Escape — выход.',
  forget: 'Забыть пиксель',
  entries: 'Всё, что касалось пикселя',
  outcomes: { pass: 'да', fail: 'нет', paint: 'закрашен', wrong: 'неверно', note: '' },
  painted: (step) => `Закрашен на шаге ${step}`,
  unpainted: 'Его ничто не закрасило.',
  reading: 'Просмотр трассы…',
  earlier: (n) => `раньше: ${n}`,
  later: (n) => `позже: ${n}`,
  missed: (polygon) => `${polygon} не покрывает центра этого пикселя: пиксель остаётся прежним.`,
  kept: (polygon) => `В этой строке ${polygon} не меняет пикселя.`,
  because: (step) =>
    step === null ? 'Почему у него такой цвет:' : `Почему на шаге ${step} он получит этот цвет:`,
  why: {
    hides: (polygon) => `${polygon} охватывает это окно и закрывает в нём всё остальное.`,
    centre: (polygon) => `из всех, что покрывают его центр, ${polygon} ближе всех.`,
    alone: (polygon) => `в этом окне только ${polygon}, и он покрывает центр пикселя.`,
    nearest: (polygon) =>
      `${polygon} здесь ближе, чем всё нарисованное раньше, а нарисованное позже пикселя не изменило.`,
    notFarther: (polygon) =>
      `${polygon} здесь не дальше любого из нарисованных до него, и потом его ничто не заменило.`,
    empty: () => 'в этом окне не осталось многоугольников.',
    nothing: () => 'его центр не покрыт ни одним многоугольником.',
    beside: () =>
      'по вычислениям этого прогона единственный многоугольник в окне не покрывает центр пикселя.',
    region: (polygon) => `его центр лежит в видимой области, где ближе всех ${polygon}.`,
    untouched: () => 'ни один многоугольник его не закрасил.',
  },
  whyBackground: (step) =>
    step === null ? 'Почему здесь фон:' : `Почему на шаге ${step} здесь будет фон:`,
};
