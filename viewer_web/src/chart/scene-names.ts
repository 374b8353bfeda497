import type { Language } from '../language/language.js';
import names from '../trace/scene-names.json' with { type: 'json' };

/** The name of a scene in the language. A name that is not of the course remains as it is. */
export function nameIn(language: Language, name: string): string {
  return names.find(({ en }) => en === name)?.[language] ?? name;
}
