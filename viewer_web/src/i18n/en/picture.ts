import type { PictureTexts } from '../texts.js';

export const picture: PictureTexts = {
  zoom: 'Zoom',
  out: 'Smaller',
  in: 'Larger',
  whole: 'Whole picture',
};
