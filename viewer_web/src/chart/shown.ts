import { chartTexts } from '../i18n/chart.js';
import type { ChartTexts } from '../i18n/chart.js';
import type { Language } from '../i18n/language.js';
import type { Choice } from './choice.js';
import type { Chart, Cost, ErrorMeasure } from './format.js';
import { byCost } from './front.js';
import { areaOfRight, pointsOf } from './points.js';
import type { Point } from './points.js';
import { isHidden, printed, seriesOf } from './series.js';
import type { Series, Setting } from './series.js';
import { viewsOf } from './views.js';
import type { View } from './views.js';

/** A chart as the components show it. */
export interface Shown {
  readonly views: readonly View[];
  readonly view: View;
  readonly cost: Cost;
  readonly error: ErrorMeasure;
  readonly rounds: number;
  /** All runs that have a place; what is hidden has one too, so that axes and front stay as they are. */
  readonly points: readonly Point[];
  readonly visible: readonly Point[];
  /** By cost. */
  readonly front: readonly Point[];
  readonly missing: readonly Setting[];
  readonly areaOfRight: number | null;
  readonly series: readonly Series[];
  readonly hasPrinted: boolean;
  /** Whether the chart holds its scenes. */
  readonly hasScenes: boolean;
  readonly hidden: ReadonlySet<string>;
  readonly language: Language;
  readonly texts: ChartTexts;
}

export function shownOf(chart: Chart, choice: Choice, language: Language): Shown | null {
  const { cost, error, hidden } = choice;
  const views = viewsOf(chart);
  const view = views.find(({ id }) => id === choice.view) ?? views[0];
  if (view === undefined) return null;
  const { points, missing } = pointsOf(view.scenes, cost, error);
  const settings = [...points.map(({ setting }) => setting), ...missing];
  return {
    views,
    view,
    cost,
    error,
    rounds: chart.rounds,
    points,
    visible: points.filter(({ setting }) => !isHidden(setting, hidden)),
    front: points.filter(({ front }) => front).sort(byCost),
    missing,
    areaOfRight: areaOfRight(view.scenes, error),
    series: seriesOf(settings),
    hasScenes: chart.scenes.some(({ scene }) => scene !== undefined),
    hasPrinted: settings.some(({ edition }) => edition === printed),
    hidden,
    language,
    texts: chartTexts[language],
  };
}
