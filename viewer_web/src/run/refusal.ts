import type { SceneTexts } from '../language/scene-texts.js';
import type { Sketch } from './sketch.js';

export interface SceneRefusal {
  /** The polygon that is at fault, if it is one. */
  readonly polygon: string | null;
  readonly reason: string;
}

/** Without the name of another polygon. */
const impersonal = (reason: string): string =>
  reason.replace(/ of polygon .* before it/su, ' of another one before it');

/**
 * What the library says of a scene that it does not take, "scene: /polygons/0/vertices: not convex", or that the method does
 * not, "scene: polygon A has no area".
 */
export function refusalOf(message: string, { polygons }: Sketch): SceneRefusal {
  const line = message.trim().replace(/^(scene|request): /u, '');
  const named = /^polygon (.+?) ((?:has|is|goes) .*)$/su.exec(line);
  if (named !== null) return { polygon: named[1] ?? null, reason: impersonal(named[2] ?? '') };
  const [, place = '', reason = line] = /^(\/\S*): (.*)$/su.exec(line) ?? [];
  const [, number] = /^\/polygons\/(\d+)/u.exec(place) ?? [];
  const polygon = number === undefined ? undefined : polygons[Number(number)];
  return { polygon: polygon?.id ?? (place === '' ? null : place), reason };
}

/** The same as a sentence. */
export function whyRefused(message: string, sketch: Sketch, say: SceneTexts): string {
  const { polygon, reason } = refusalOf(message, sketch);
  if (polygon === '/function') return ofFormula(reason, say);
  return say.refused(polygon, inWords(reason, say));
}

/** What is wrong with the function of a surface, perhaps with the place where it is. */
function ofFormula(reason: string, say: SceneTexts): string {
  const [, x, z] = /^not finite at x = (\S+), z = (\S+)$/u.exec(reason) ?? [];
  return x === undefined || z === undefined
    ? say.formula(inWords(reason, say))
    : say.notFiniteAt(Number(x), Number(z));
}

/** A reason may say first what it is about: "rint: no such function". */
function inWords(reason: string, { reasons }: SceneTexts): string {
  const [, about = '', rest = ''] = /^(.*): (.*)$/su.exec(reason) ?? [];
  const known = reasons[rest];
  return reasons[reason] ?? (known === undefined ? reason : `${about}: ${known}`);
}
