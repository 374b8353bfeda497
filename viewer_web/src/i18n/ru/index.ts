import type { Texts } from '../../language/texts.js';
import { atlas } from './atlas.js';
import { bookmarks } from './bookmarks.js';
import { compare } from './compare.js';
import { curves } from './curves.js';
import { exact } from './exact.js';
import { family } from './family.js';
import { history } from './history.js';
import * as numbers from './numbers.js';
import { outline } from './outline.js';
import { page, places } from './page.js';
import { picture } from './picture.js';
import { predict } from './predict.js';
import { reader } from './reader.js';
import { reasons } from './reasons.js';
import { regions } from './regions.js';
import { scene } from './scene.js';
import { solid } from './solid.js';
import { strip } from './strip.js';
import { travel } from './travel.js';
import { why } from './why.js';
import { tour, words } from './words.js';

export const texts: Texts = {
  numbers,
  page,
  places,
  reasons,
  history,
  why,
  travel,
  strip,
  bookmarks,
  picture,
  predict,
  scene,
  curves,
  exact,
  solid,
  compare,
  reader,
  family,
  regions,
  words,
  tour,
  outline,
  atlas,
};
