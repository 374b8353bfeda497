import type { RegionTexts } from '../../language/texts.js';

export const regions: RegionTexts = {
  lists: 'Стек списков',
  list: 'Текущий список',
  clip: 'отсекающий',
  ground: 'фон',
  inside: 'Внутри',
  outside: 'Снаружи',
  behind: 'сзади',
  nearer: 'ближе',
  visible: 'Видимые области',
  shown: 'видимых',
  area: 'площадь',
  vertices: { one: 'вершина', few: 'вершины', other: 'вершин' },
  pieces: 'Части',
  loops: { one: 'контур', few: 'контура', other: 'контуров' },
  layers: {
    pixels: 'пиксели',
    visible: 'видимое',
    list: 'список',
    parts: 'внутри, снаружи',
    crossings: 'пересечения',
  },
  layersName: 'Что из областей показано на изображении',
};
