import { algorithmOf } from '../algorithm/algorithm.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import type { SolidTexts } from '../language/solid-texts.js';
import type { Space } from './space.js';

/** A description of the box: first what never changes in a scene, then what the step shows. */
export function caption(view: View, space: Space, texts: SolidTexts): readonly string[] {
  const [far, near] = space.depths.map(numbersOf(view).short);
  const depths = texts.depths(far ?? '', near ?? '');
  return [depths, ...(algorithmOf(view.header).solid?.caption(view, texts) ?? [])];
}
