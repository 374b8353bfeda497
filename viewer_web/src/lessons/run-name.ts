import { texts } from '../i18n/index.js';
import { editionName } from '../language/family.js';
import type { Language } from '../language/language.js';
import { nameIn } from '../language/scene-name.js';
import type { PageTexts } from '../language/texts.js';
import type { LessonTrace } from './lessons.js';

/** The name of a lesson's run: its title, and its method with any unusual settings. */
export function runName(
  { file, title, method, kernel, edition }: LessonTrace,
  page: PageTexts,
  language: Language,
): { readonly title: string; readonly way: string } {
  const way = [
    page.methods[method],
    ...(edition === 'corrected' ? [] : [editionName(page.editions, edition)]),
    ...(kernel === 'double' ? [] : [kernel]),
    ...(file.includes('.checked.') ? [page.checked] : []),
  ].join(', ');
  return { title: title?.[language] ?? way, way };
}

/** Both in one line. */
export function runLabel(trace: LessonTrace, page: PageTexts, language: Language): string {
  const { title, way } = runName(trace, page, language);
  return title === way ? way : `${title} (${way})`;
}

/** The name of a scene as a title. */
export const sceneTitle = (language: Language, name: string): string =>
  nameIn(language, name) || texts[language].page.unnamed;
