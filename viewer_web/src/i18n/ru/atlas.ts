import type { AtlasTexts } from '../../language/texts.js';

export const atlas: AtlasTexts = {
  title: 'Атлас ошибок',
  short: 'Атлас',
  close: 'Закрыть',
  show: 'Показать',
  all: 'все',
  kinds: {
    rounding: 'округление',
    printed: 'ошибки печатного текста',
    mistake: 'типичные ошибки',
    limit: 'пределы метода',
    test: 'без сцены',
  },
  noScene: 'сценой не показать',
  remedy: 'Исправление',
  unproved: 'Почему у изображения нет доказательства',
  at: (step, there) => `Шаг ${step}: ${there}`,
  goTo: 'К шагу',
  compare: 'Сравнить с исправленным',
  leave: 'Закончить сравнение',
  forget: 'Скрыть',
};
