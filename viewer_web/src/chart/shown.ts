import { chartTexts } from '../i18n/chart.js';
import type { ChartTexts, SubjectTexts } from '../language/texts.js';
import type { Language } from '../language/language.js';
import type { Choice } from './choice.js';
import type { Chart, Cost, ErrorMeasure } from './format.js';
import { areaOfRight, byCost, pointsOf } from './points.js';
import type { Point } from './points.js';
import { mainOf } from './main.js';
import type { Main } from './main.js';
import { front, isVariant, printed, seriesId, seriesOf, settingId } from './series.js';
import type { Series, Setting } from './series.js';
import { axesOf, fileOf, viewsOf } from './subject.js';
import type { Axes, View } from './subject.js';

/** A chart as the components show it. */
export interface Shown {
  readonly views: readonly View[];
  readonly view: View;
  readonly axes: Axes;
  readonly cost: Cost;
  readonly error: ErrorMeasure;
  readonly rounds: number;
  /** All runs that have a point, also those that are not shown. */
  readonly points: readonly Point[];
  /** The answer that the chart opens with, sorted by cost. */
  readonly main: readonly Point[];
  readonly answer: Main;
  /** The points of the chosen series, except those among the main ones, which it fades. */
  readonly added: readonly Point[];
  readonly visible: readonly Point[];
  readonly missing: readonly Setting[];
  /** The error of the right picture: 0, except where even that one differs from the visible regions. */
  readonly least: number;
  /** The series that can be added, and the chosen one. */
  readonly series: readonly Series[];
  readonly hasPrinted: boolean;
  readonly chosenSeries: string | null;
  /** Whether the chart contains the files of its subjects. */
  readonly hasFiles: boolean;
  readonly language: Language;
  readonly texts: ChartTexts;
  /** The texts that differ between scenes and surfaces. */
  readonly subjectTexts: SubjectTexts;
}

/** The chosen item if the list has it, or else the first one. */
function chosenOf<T>([first, ...others]: readonly [T, ...T[]], chosen: T | null): T {
  return others.find((each) => each === chosen) ?? first;
}

/** Whether all runs of the setting's series are main points or of the printed edition. */
const isCompared = ({ method, knob }: Setting): boolean => knob === null && !isOther(method);
const isOther = (method: Setting['method']): boolean =>
  method === 'weiler-atherton' || (method !== 'floating-horizon' && isVariant(method));

function isIn({ setting, front: isOnFront }: Point, series: string | null): boolean {
  if (series === front) return isOnFront;
  if (series === printed) return setting.edition === printed && setting.knob === null;
  return seriesId(setting) === series;
}

export function shownOf(chart: Chart, choice: Choice, language: Language): Shown | null {
  const views = viewsOf(chart);
  const view = views.find(({ id }) => id === choice.view) ?? views[0];
  if (view === undefined) return null;
  const { subjects } = view;
  const axes = axesOf(subjects);
  const cost = chosenOf(axes.costs, choice.cost);
  const error = chosenOf(axes.errors, choice.error);
  const { points, missing } = pointsOf(subjects, cost, error);
  const settings = [...points.map(({ setting }) => setting), ...missing];
  const answer = mainOf(subjects, cost);
  const isMain = ({ setting }: Point): boolean => answer.ids.has(settingId(setting));
  const main = points.filter(isMain).sort(byCost);
  const series = seriesOf(settings.filter((setting) => !isCompared(setting)));
  const hasPrinted = settings.some(({ edition }) => edition === printed);
  const offered = [...series.map(({ id }) => id), front, ...(hasPrinted ? [printed] : [])];
  const chosenSeries = offered.find((id) => id === choice.series) ?? null;
  const added = points.filter((point) => !isMain(point) && isIn(point, chosenSeries));
  return {
    views,
    view,
    axes,
    cost,
    error,
    rounds: chart.rounds,
    points,
    main,
    answer,
    added,
    visible: [...main, ...added],
    missing,
    least: areaOfRight(subjects, error) ?? 0,
    series,
    hasPrinted,
    chosenSeries,
    hasFiles: subjects.some((subject) => fileOf(subject) !== undefined),
    language,
    texts: chartTexts[language],
    subjectTexts: chartTexts[language].subjects[view.kind === 'surfaces' ? 'surfaces' : 'scenes'],
  };
}
