import type { PictureTexts } from '../picture-texts.js';

export const picture: PictureTexts = {
  zoom: 'Масштаб',
  out: 'Мельче',
  in: 'Крупнее',
  whole: 'Всё изображение',
};
