import { filled, valuesIn } from '../base/filled.js';
import type { SceneTexts } from './texts.js';

/**
 * The library's reason for a refusal in the language of the page. It may begin with its subject, "rint: no such function", or
 * with its place, "line 3: a negative count".
 */
export function inWords(reason: string, say: SceneTexts): string {
  const { reasons, missing } = say;
  const [, lacking] = /^"([^"]+)" is missing$/u.exec(reason) ?? [];
  if (lacking !== undefined) return missing(lacking);
  const whole = known(reason, reasons);
  if (whole !== undefined) return whole;
  for (let at = reason.indexOf(': '); at >= 0; at = reason.indexOf(': ', at + 1)) {
    const [about, end] = [reason.slice(0, at), known(reason.slice(at + 2), reasons)];
    if (end !== undefined) return `${placed(about, say)}: ${end}`;
  }
  return reason;
}

/** What the scene of a mesh lacks, "line 3: left out: textures (2 times, here first)", in the language of the page. */
export function lossInWords(loss: string, say: SceneTexts): string {
  const [, place = '', what = loss, times] =
    /^(.*?): left out: (.*?)(?: \((\d+) times, here first\))?$/su.exec(loss) ?? [];
  return say.leftOut(
    placed(place, say),
    inWords(what, say),
    times === undefined ? 1 : Number(times),
  );
}

/** A subject, "cube.obj: line 3", with the place at its end in the language of the page. */
function placed(about: string, { placeInFile }: SceneTexts): string {
  return about.replace(/(line|face|vertex) (\d+)$/u, (_, kind, number) =>
    placeInFile(kind as 'line' | 'face' | 'vertex', number as string),
  );
}

/** The words for a reason, which may have values in place of `{}`. */
function known(reason: string, reasons: SceneTexts['reasons']): string | undefined {
  if (reason in reasons) return reasons[reason];
  for (const [words, own] of Object.entries(reasons)) {
    const values = words.includes('{}') ? valuesIn(words, reason) : null;
    if (values !== null) return filled(own, ...values);
  }
  return undefined;
}
