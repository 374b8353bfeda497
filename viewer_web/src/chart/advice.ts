import { number } from './numbers.js';
import type { Point } from './points.js';
import type { Shown } from './shown.js';
import { fullName } from './words.js';

/** One of the three runs of the advice; its point is null if no main run is such. */
export interface AdviceRow {
  readonly title: string;
  readonly point: Point | null;
}

export function adviceRows({ answer, texts }: Shown): readonly AdviceRow[] {
  const { cheapest, safe, wrong } = texts.advice;
  return [
    { title: cheapest, point: answer.cheapest },
    { title: safe, point: answer.safe },
    { title: wrong, point: answer.wrong },
  ];
}

/** A sentence on which run is needed. */
export function adviceText(shown: Shown): string {
  const { answer, texts, subjectTexts, language } = shown;
  const { cheapest, safe } = answer;
  if (cheapest === null) return subjectTexts.noneRight;
  const name = fullName(cheapest.setting, shown);
  const { same, safer, unsafe } = texts.advice;
  if (safe === null) return unsafe(name);
  if (safe === cheapest) return same(name);
  return safer(name, number(safe.cost / cheapest.cost, language));
}
