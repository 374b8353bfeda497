import { algorithmOf } from '../algorithm/algorithm.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { noteOf } from '../listing/notes.js';
import { kinds } from '../trace/events.js';
import type { Outline } from './outline.js';
import type { Told } from './outlined.js';

/** The maximum length of a note: a list in it may be far longer than a row. */
const longest = 60;

/** A procedure with its result, as in the listing's notes: "SurroundTest A: true". */
function sayCall({ kind, last, header, event }: Told, language: Language): string {
  const result = event(last);
  if (result === null || kinds[result.e].resultOf !== kind) return kind;
  const polygon = 'polygon' in result ? (result.polygon ?? '') : '';
  const note = noteOf(result, header.method, texts[language].numbers)?.slice(0, longest) ?? '';
  if (note === '' || note === polygon || note.startsWith(`${polygon}:`)) {
    return `${kind} ${note || polygon}`.trim();
  }
  return `${polygon === '' ? kind : `${kind} ${polygon}`}: ${note}`;
}

/** The text of a node. */
export function sayNode(outline: Outline, node: number, language: Language): string {
  const told = outline.told(node);
  return algorithmOf(told.header).outline.say(told, language) ?? sayCall(told, language);
}
