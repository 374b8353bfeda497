import { isSampling, mostly } from './advice.js';
import type { Advice, Losses, Means } from './advice.js';
import { number, percent, ratio, whole } from './numbers.js';
import type { Point } from './points.js';
import type { Shown } from './shown.js';
import { costAmount, fullName } from './words.js';

/** The name of a run, and its cost as a multiple of the cheapest right run's. */
function compared(point: Point, cheapest: Point, shown: Shown): string {
  const { texts, language } = shown;
  const times = ratio(point.cost / cheapest.cost, language);
  const most = point.run && mostly(point.run);
  const spent = most === null ? null : texts.operations[most[0]](percent(most[1], language));
  const details = spent === null ? times : `${times}; ${spent}`;
  return `${fullName(point.setting, shown)} (${details})`;
}

/** Why samples matter: the error between them, and the decisions that arithmetic gets wrong. */
function lossText({ height, decisions }: Losses, { texts, language }: Shown): string {
  const { losses, units } = texts;
  const kernels = [...decisions].map(
    ([kernel, share]) => `${kernel} (${percent(share, language)})`,
  );
  return [
    height === 0 ? losses.nothing : losses.height(units.height(number(height, language))),
    kernels.length === 0 ? losses.noDecision : losses.decisions(kernels.join(', ')),
  ].join(' ');
}

/** A paragraph on which run is needed, and why. */
export function adviceText(advice: Advice | null, shown: Shown): string {
  const { texts, subjectTexts, cost, language } = shown;
  const { advice: say } = subjectTexts;
  if (advice === null) return say.none;
  const { cheapest, cheaper, safe, others, neverRight, losses } = advice;
  const name = (point: Point): string => fullName(point.setting, shown);
  const nameOf = (means: Means): string =>
    isSampling(means) ? texts.samplings[means] : texts.methods[means];
  const [amount] = costAmount(cheapest, shown);
  const sentences = [say.cheapest(name(cheapest), texts.costs[cost].name.toLowerCase(), amount)];
  const [leastWrong] = cheaper;
  if (leastWrong !== undefined) {
    const wrong = percent(leastWrong.error, language);
    sentences.push(say.cheaper(whole(cheaper.length, language), name(leastWrong), wrong));
  }
  if (losses !== null) sentences.push(lossText(losses, shown));
  if (safe === cheapest) sentences.push(say.safe);
  else if (safe !== null) {
    sentences.push(say.safer(name(safe), ratio(safe.cost / cheapest.cost, language)));
  }
  if (others.length > 0) {
    sentences.push(say.others(others.map((point) => compared(point, cheapest, shown)).join('; ')));
  }
  if (neverRight.length > 0) {
    sentences.push(say.neverRight(neverRight.map(nameOf).join(', ')));
  }
  return sentences.join(' ');
}
