import { chartTexts } from '../i18n/chart.js';
import type { ChartTexts, SubjectTexts } from '../language/texts.js';
import type { Language } from '../language/language.js';
import type { Choice } from './choice.js';
import type { Chart, Cost, ErrorMeasure } from './format.js';
import { areaOfRight, byCost, pointsOf } from './points.js';
import type { Point } from './points.js';
import { isHidden, printed, seriesOf } from './series.js';
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
  /** All runs that have a point. Hidden ones are included, so that axes and front do not change. */
  readonly points: readonly Point[];
  readonly visible: readonly Point[];
  /** Sorted by cost. */
  readonly front: readonly Point[];
  readonly missing: readonly Setting[];
  readonly areaOfRight: number | null;
  readonly series: readonly Series[];
  readonly hasPrinted: boolean;
  /** Whether the chart contains the files of its subjects. */
  readonly hasFiles: boolean;
  readonly hidden: ReadonlySet<string>;
  readonly language: Language;
  readonly texts: ChartTexts;
  /** The texts that differ between scenes and surfaces. */
  readonly subjectTexts: SubjectTexts;
}

/** The chosen item if the list has it, or else the first one. */
function chosenOf<T>([first, ...others]: readonly [T, ...T[]], chosen: T | null): T {
  return others.find((each) => each === chosen) ?? first;
}

export function shownOf(chart: Chart, choice: Choice, language: Language): Shown | null {
  const { hidden } = choice;
  const views = viewsOf(chart);
  const view = views.find(({ id }) => id === choice.view) ?? views[0];
  if (view === undefined) return null;
  const { subjects } = view;
  const axes = axesOf(subjects);
  const cost = chosenOf(axes.costs, choice.cost);
  const error = chosenOf(axes.errors, choice.error);
  const { points, missing } = pointsOf(subjects, cost, error);
  const settings = [...points.map(({ setting }) => setting), ...missing];
  return {
    views,
    view,
    axes,
    cost,
    error,
    rounds: chart.rounds,
    points,
    visible: points.filter(({ setting }) => !isHidden(setting, hidden)),
    front: points.filter(({ front }) => front).sort(byCost),
    missing,
    areaOfRight: areaOfRight(subjects, error),
    series: seriesOf(settings),
    hasFiles: subjects.some((subject) => fileOf(subject) !== undefined),
    hasPrinted: settings.some(({ edition }) => edition === printed),
    hidden,
    language,
    texts: chartTexts[language],
    subjectTexts: chartTexts[language].subjects[view.kind === 'surfaces' ? 'surfaces' : 'scenes'],
  };
}
