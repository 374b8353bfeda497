import { inWords } from '../language/library-reason.js';
import type { SceneTexts } from '../language/texts.js';
import type { Sketch } from './sketch.js';

export interface SceneRefusal {
  /** The polygon at fault, if it is one. */
  readonly polygon: string | null;
  readonly reason: string;
}

/** An error in a file: its position in the text, if known, and its place in the document. */
export interface Fault {
  readonly line: number | null;
  readonly column: number | null;
  readonly place: string;
  readonly reason: string;
}

/** The library's messages about a file that it refuses, one per line. */
export function faultsOf(messages: string): readonly Fault[] {
  return messages
    .split('\n')
    .map((line) => line.trim().replace(/^(scene|request): /u, ''))
    .filter((line) => line !== '')
    .map((line) => {
      const [, row, column, text = line] = /^line (\d+), column (\d+): (.*)$/su.exec(line) ?? [];
      const [, place = '', reason = text] = /^(\/\S*): (.*)$/su.exec(text) ?? [];
      const at = (number: string | undefined): number | null =>
        number === undefined ? null : Number(number);
      return { line: at(row), column: at(column), place, reason };
    });
}

/** A fault in words: place and reason. */
export function inWordsOf({ line, column, place, reason }: Fault, say: SceneTexts): string {
  const where = line === null || column === null ? [] : [say.at(line, column)];
  return [...where, ...(place === '' ? [] : [place]), inWords(reason, say)].join(': ');
}

/** The reason without the name of another polygon. */
const impersonal = (reason: string): string =>
  reason.replace(/ of polygon .* in front of it/su, ' of another one in front of it');

/**
 * The library's first reason for refusing a sketch, "scene: line 1, column 60: /polygons/0/vertices: not convex", or the
 * method's, "scene: polygon A has no area". A sketch has no lines.
 */
export function refusalOf(messages: string, { polygons }: Sketch): SceneRefusal {
  const [fault] = faultsOf(messages);
  if (fault === undefined) return { polygon: null, reason: '' };
  const { place, reason } = fault;
  const named = /^polygon (.+?) ((?:has|is|goes) .*)$/su.exec(reason);
  if (named !== null) return { polygon: named[1] ?? null, reason: impersonal(named[2] ?? '') };
  const [, number] = /^\/polygons\/(\d+)/u.exec(place) ?? [];
  const polygon = number === undefined ? undefined : polygons[Number(number)];
  return { polygon: polygon?.id ?? (place === '' ? null : place), reason };
}

/** The library's first reason as a sentence. */
export function whyRefused(message: string, sketch: Sketch, say: SceneTexts): string {
  const { polygon, reason } = refusalOf(message, sketch);
  if (polygon === '/function') return say.formula(inWords(reason, say));
  return say.refused(polygon, inWords(reason, say));
}
