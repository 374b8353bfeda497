import type { Language } from '../language/language.js';
import { duration, number, percent, ratio, whole } from './numbers.js';
import { wholeOf } from './points.js';
import type { Point } from './points.js';
import { isOfCurves, isVariant, printed } from './series.js';
import type { Setting } from './series.js';
import type { Shown } from './shown.js';
import { errorOf, isDistance, isSurface } from './subject.js';

type Worded = Pick<Shown, 'texts' | 'subjectTexts' | 'language'>;

/** The value of a knob; a count has all its digits. */
export function knobValue({ value }: Setting, language: Language): string {
  const found = value ?? 0;
  return Number.isInteger(found) ? whole(found, language) : number(found, language);
}

/** The knob and its value; null if there is no knob. */
function turned(setting: Setting, { texts, language }: Worded): string | null {
  const { knob } = setting;
  return knob === null ? null : texts.turned[knob](knobValue(setting, language));
}

/** The name of a run of curves begins with its samples. */
function samplingName(setting: Setting, worded: Worded): string {
  return turned(setting, worded) ?? worded.subjectTexts.fixed;
}

export function runName(setting: Setting, worded: Worded): string {
  const { kernel } = setting;
  if (isOfCurves(setting)) return `${kernel}, ${samplingName(setting, worded)}`;
  const { method } = setting;
  return `${worded.texts.methods[method]}${isVariant(method) ? ',' : ''} ${kernel}`;
}

/** The name of what the main points compare under several kernels: a method, or how a surface's curves are sampled. */
export function groupName(setting: Setting, worded: Worded): string {
  return isOfCurves(setting) ? samplingName(setting, worded) : worded.texts.methods[setting.method];
}

/** The name in places without details. Runs that differ in their smallest window have the same kernel. */
export function fullName(setting: Setting, worded: Worded): string {
  const name = runName(setting, worded);
  return setting.knob === 'window' ? `${name} (${turned(setting, worded) ?? ''})` : name;
}

/** The knob, if the name does not include it, and the edition. */
export function runDetails({ setting, complete }: Point, worded: Worded): string {
  const { texts } = worded;
  const details = [
    isOfCurves(setting) ? null : turned(setting, worded),
    setting.edition === printed ? texts.editions.printed : null,
    complete ? null : texts.fault,
  ];
  return details.filter((each) => each !== null).join(' · ');
}

/** A number as shown, and the counted value if the number is a ratio. */
export type Amount = readonly [shown: string, counted: string | null];

export function costAmount({ cost, run }: Point, { language, ...shown }: Shown): Amount {
  if (run === null) return [ratio(cost, language), null];
  if (shown.cost !== 'time') return [whole(cost, language), null];
  return [ratio(cost, language), duration(run.seconds, language)];
}

export function errorAmount({ error, run }: Point, shown: Shown): Amount {
  const { texts, language, view } = shown;
  if (isDistance(shown.error)) return [texts.units[shown.error](number(error, language)), null];
  const [subject] = view.subjects;
  if (run === null || subject === undefined) return [percent(error, language), null];
  const part = errorOf(run, shown.error);
  const counted = Number.isInteger(part) ? whole(part, language) : number(part, language);
  const all = whole(wholeOf(run, subject, shown.error), language);
  return [percent(error, language), texts.counted(counted, all)];
}

export function inLine([shown, counted]: Amount): string {
  return counted === null ? shown : `${shown} (${counted})`;
}

/** The lines that describe a point. */
export function pointLines(point: Point, shown: Shown): readonly string[] {
  const { texts, cost, error } = shown;
  const { setting } = point;
  const details = runDetails(point, shown);
  return [
    runName(setting, shown),
    ...(details === '' ? [] : [details]),
    `${texts.costs[cost].name}: ${inLine(costAmount(point, shown))}`,
    `${texts.errors[error].name}: ${inLine(errorAmount(point, shown))}`,
  ];
}

/** The meaning of the axes. */
export function explanation({ view, cost, error, rounds, texts, language }: Shown): string {
  const [costs, errors] = [texts.costs[cost], texts.errors[error]];
  const sentences =
    view.name === null
      ? [costs.ratioSentence, errors.meanSentence]
      : [costs.sentence(whole(rounds, language)), errors.sentence];
  return [...sentences, texts.reading].join(' ');
}

/** The size of the subject; null if several are shown. */
export function sizeText({ view, texts, language }: Shown): string | null {
  const [subject] = view.subjects;
  if (view.name === null || subject === undefined) return null;
  const said = (n: number): string => whole(n, language);
  if (isSurface(subject)) return texts.aboutSurface(said(subject.curves), said(subject.columns));
  const { pixels, polygons, unsteady } = subject;
  return texts.aboutScene(said(pixels), said(polygons), said(unsteady));
}

/** The runs that have no point, and why; null if all have one. A variant that does not take every scene is named once. */
export function missingText(shown: Shown): string | null {
  const { missing, points, view, texts, subjectTexts } = shown;
  if (missing.length === 0) return null;
  const most = 8;
  const plotted = new Set(points.map(({ setting }) => setting.method));
  const nameOf = (setting: Setting): string => {
    if (isOfCurves(setting)) return samplingName(setting, shown);
    return plotted.has(setting.method) ? setting.kernel : texts.methods[setting.method];
  };
  const names = [...new Set(missing.map(nameOf))];
  const listed = [...names.slice(0, most), ...(names.length > most ? ['…'] : [])].join(', ');
  return view.name === null ? subjectTexts.missingSomewhere(listed) : texts.missing(listed);
}
