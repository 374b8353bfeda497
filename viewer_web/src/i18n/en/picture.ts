import type { PictureTexts } from '../picture-texts.js';

export const picture: PictureTexts = {
  zoom: 'Zoom',
  out: 'Smaller',
  in: 'Larger',
  whole: 'Whole picture',
};
