import type { PictureTexts } from '../../language/texts.js';

export const picture: PictureTexts = {
  zoom: 'Масштаб',
  legend: 'Легенда',
  readout: { unpainted: 'ещё не закрашен', background: 'фон', or: ' или ' },
  out: 'Мельче',
  in: 'Крупнее',
  whole: 'Всё изображение',
  all: 'Все вершины, включая те, что вне изображения',
  layer: 'Что показывают пиксели',
  layers: {
    picture: 'Закрашенное',
    depths: 'Глубины',
    exact: 'Точное',
    difference: 'Разница',
  },
  soFar: 'что закрашено к этому шагу',
  exactly: 'ближайший в центре пикселя',
  computing: 'Вычисляется…',
  ramp: 'Чем светлее, тем ближе',
  fromTo: (far, near) => `глубины от ${far} (тёмные) до ${near} (светлые)`,
  wrong: (n) => `неверного цвета: ${n}`,
  lacking: (n) => `ещё не закрашено: ${n}`,
};
