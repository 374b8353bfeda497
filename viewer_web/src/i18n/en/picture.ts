import type { PictureTexts } from '../../language/picture-texts.js';

export const picture: PictureTexts = {
  zoom: 'Zoom',
  legend: 'Legend',
  readout: { unpainted: 'not painted yet', background: 'background', or: ' or ' },
  out: 'Smaller',
  in: 'Larger',
  whole: 'Whole picture',
  all: 'All vertices, including those outside the picture',
  layer: 'What the pixels show',
  layers: {
    picture: 'Picture so far',
    depths: 'Depths',
    exact: 'Exact picture',
    difference: 'Difference',
  },
  soFar: 'what this run has painted',
  exactly: 'the nearest polygon at the centre of each pixel',
  computing: 'Computing the exact picture…',
  ramp: 'The lighter, the nearer',
  fromTo: (far, near) => `depths from ${far} (dark) to ${near} (light)`,
  wrong: (n) => `${n} with a wrong colour`,
  lacking: (n) => `${n} not painted yet`,
};
