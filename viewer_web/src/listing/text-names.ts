import names from '../../../lessons/names.json';
import type { Language } from '../language/language.js';
import type { Method } from '../trace/events.js';

/** A name in a text of the course, our name for the same thing, and what it means. */
export interface TextName {
  readonly name: string;
  readonly term: string;
  readonly line: string;
}

/** The texts that a method follows, by their letters in lessons/TEXTS.md. */
function textsOf(method: Method): string {
  if (method === 'warnock') return 'A';
  if (method === 'zbuffer') return 'B';
  if (method === 'floating-horizon') return 'D';
  return method === 'weiler-atherton' ? 'C' : 'AC';
}

export const textNames = (method: Method, language: Language): readonly TextName[] =>
  names
    .filter(({ text }) => textsOf(method).includes(text))
    .map(({ name, [language]: ours }) => ({ name, ...ours }));
