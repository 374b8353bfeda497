import type { Language } from './language.js';
import names from '../trace/scene-names.json' with { type: 'json' };

/** The name of a scene in the language. An exercise made from a scene has its name and a number. Other names remain as they are. */
export function nameIn(language: Language, name: string): string {
  const [, known = name, number = ''] = /^(.*?)( · .*)$/.exec(name) ?? [];
  const found = names.find(({ en }) => en === known)?.[language];
  return found === undefined ? name : found + number;
}
