import type { PictureTexts } from '../texts.js';

export const picture: PictureTexts = {
  zoom: 'Масштаб',
  out: 'Мельче',
  in: 'Крупнее',
  whole: 'Всё изображение',
};
