import { editionName } from '../language/family-texts.js';
import type { PageTexts } from '../language/texts.js';
import type { LessonTrace } from './lessons.js';

/** A run of a lesson in words: its method, and in what it is not as usual. */
export function runName(
  { file, method, kernel, edition, scene }: LessonTrace,
  page: PageTexts,
): { readonly method: string; readonly variant: string } {
  const unusual = [
    ...(edition === 'corrected' ? [] : [editionName(page.editions, edition)]),
    ...(kernel === 'double' ? [] : [kernel]),
    ...(file.includes('.checked.') ? [page.checked] : []),
    ...(scene === undefined ? [] : [page.scene(scene)]),
  ];
  return { method: page.methods[method], variant: unusual.join(', ') };
}
