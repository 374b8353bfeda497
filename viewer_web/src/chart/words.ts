import type { ChartTexts } from '../i18n/chart.js';
import type { Run } from './format.js';
import { duration, number, percent, ratio, whole } from './numbers.js';
import type { Point } from './points.js';
import { isVariant } from './series.js';
import type { Setting } from './series.js';
import type { Shown } from './shown.js';

export function runName({ method, kernel }: Setting, texts: ChartTexts): string {
  return `${texts.methods[method]}${isVariant(method) ? ',' : ''} ${kernel}`;
}

/** What was turned, and which text was run. */
export function runDetails({ setting, complete }: Point, texts: ChartTexts): string {
  const { knob, value, edition } = setting;
  const turned = knob === null ? [] : [texts.turned[knob](String(value))];
  const fault = complete ? [] : [texts.fault];
  return [...turned, texts.editions[edition], ...fault].join(' · ');
}

/** A number that is shown, and what was counted where it is a ratio. */
export type Amount = readonly [shown: string, counted: string | null];

export function costAmount({ cost, run }: Point, { language, ...shown }: Shown): Amount {
  if (run === null) return [ratio(cost, language), null];
  if (shown.cost !== 'time') return [whole(cost, language), null];
  return [ratio(cost, language), duration(run.seconds, language)];
}

/** What was counted, and of how many. */
function counts(run: Run, { error, view }: Shown): readonly [number, number] {
  if (error === 'wrongDecisions') return [run.wrongDecisions, run.decisions];
  return [error === 'area' ? run.area : run.wrongPixels, view.scenes[0]?.pixels ?? 0];
}

export function errorAmount({ error, run }: Point, shown: Shown): Amount {
  const { texts, language } = shown;
  if (shown.error === 'depthUlps') return [texts.ulps(number(error, language)), null];
  if (run === null) return [percent(error, language), null];
  const [part, all] = counts(run, shown);
  const counted = Number.isInteger(part) ? whole(part, language) : number(part, language);
  return [percent(error, language), texts.counted(counted, whole(all, language))];
}

function inLine([shown, counted]: Amount): string {
  return counted === null ? shown : `${shown} (${counted})`;
}

/** A point in words, by lines. */
export function pointLines(point: Point, shown: Shown): readonly string[] {
  const { texts, cost, error } = shown;
  const { setting } = point;
  return [
    runName(setting, texts),
    runDetails(point, texts),
    `${texts.costs[cost].name}: ${inLine(costAmount(point, shown))}`,
    `${texts.errors[error].name}: ${inLine(errorAmount(point, shown))}`,
  ];
}

/** What the axes mean. */
export function explanation({ view, cost, error, rounds, texts, language }: Shown): string {
  const [costs, errors] = [texts.costs[cost], texts.errors[error]];
  const sentences =
    view.name === null
      ? [costs.ratioSentence, errors.meanSentence]
      : [costs.sentence(whole(rounds, language)), errors.sentence];
  return [...sentences, texts.reading].join(' ');
}

/** Which runs have no place in the plot, and why; null if all have. A variant that does not take each scene is named once. */
export function missingText({ missing, points, view, texts }: Shown): string | null {
  if (missing.length === 0) return null;
  const most = 8;
  const plotted = new Set(points.map(({ setting }) => setting.method));
  const nameOf = ({ method, kernel }: Setting): string =>
    plotted.has(method) ? kernel : texts.methods[method];
  const kernels = [...new Set(missing.map(nameOf))];
  const listed = [...kernels.slice(0, most), ...(kernels.length > most ? ['…'] : [])].join(', ');
  return view.name === null ? texts.missingSomewhere(listed) : texts.missing(listed);
}
