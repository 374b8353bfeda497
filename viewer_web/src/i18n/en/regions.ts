import type { PluralForms } from '../../language/words.js';
export const regions = {
  lists: 'Stack of lists',
  list: 'Current list',
  clip: 'clip polygon',
  ground: 'ground',
  inside: 'Inside',
  outside: 'Outside',
  behind: 'behind',
  nearer: 'nearer',
  visible: 'Visible regions',
  /** How many of these there are. */
  shown: 'visible',
  area: 'area',
  vertices: { one: 'vertex', other: 'vertices' } as PluralForms,
  pieces: 'Pieces',
  loops: { one: 'loop', other: 'loops' } as PluralForms,
  layers: {
    pixels: 'pixels',
    visible: 'visible',
    list: 'list',
    parts: 'inside, outside',
    crossings: 'crossings',
  },
  layersName: 'What the picture shows of the regions',
};
