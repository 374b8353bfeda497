import { filled, valuesIn } from '../base/filled.js';
import type { SceneTexts } from './texts.js';

/** The library's reason for a refusal in the language of the page. It may begin with its subject: "rint: no such function". */
export function inWords(reason: string, { reasons, missing }: SceneTexts): string {
  const [, lacking] = /^"([^"]+)" is missing$/u.exec(reason) ?? [];
  if (lacking !== undefined) return missing(lacking);
  const whole = known(reason, reasons);
  if (whole !== undefined) return whole;
  const [, about = '', rest = ''] = /^(.*): (.*)$/su.exec(reason) ?? [];
  const end = known(rest, reasons);
  return end === undefined ? reason : `${about}: ${end}`;
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
