import type { RegionTexts } from '../../language/region-texts.js';

export const regions: RegionTexts = {
  lists: 'Stack of lists',
  list: 'Current list',
  clip: 'clip polygon',
  ground: 'ground',
  inside: 'Inside',
  outside: 'Outside',
  behind: 'behind',
  nearer: 'nearer',
  visible: 'Visible regions',
  shown: 'visible',
  area: 'area',
  vertices: { one: 'vertex', other: 'vertices' },
  pieces: 'Pieces',
  loops: { one: 'loop', other: 'loops' },
  layers: {
    pixels: 'pixels',
    visible: 'visible',
    list: 'list',
    parts: 'inside, outside',
    crossings: 'crossings',
  },
  layersName: 'What the picture shows of the regions',
};
