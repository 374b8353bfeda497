import { ErrorAxis, costDomain } from './axes.js';
import type { Tick } from './axes.js';
import { joined, placeLabels, widthOf } from './labels.js';
import type { Label, Placed } from './labels.js';
import { number, percent, ratio } from './numbers.js';
import { linesOf } from './points.js';
import type { Point } from './points.js';
import { printed, seriesId } from './series.js';
import type { Setting } from './series.js';
import type { Shown } from './shown.js';
import { isDistance } from './subject.js';
import { logTicks } from './ticks.js';
import { knobValue } from './words.js';

/** The positions of everything in the plot, in pixels from the top left inside the axes. */
export interface Layout {
  readonly width: number;
  readonly height: number;
  readonly font: number;
  readonly radius: number;
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  readonly costs: readonly [number, number];
  readonly costTicks: readonly number[];
  readonly axis: ErrorAxis;
  readonly errorTicks: readonly Tick[];
  readonly heightOf: (point: Point) => number;
  readonly labels: readonly Placed[];
}

export function costTick(value: number, { cost, view, language }: Shown): string {
  const counted = cost !== 'time' && view.name !== null;
  return counted ? number(value, language) : ratio(value, language);
}

export function errorTick(value: number, { error, language }: Shown): string {
  const counted = isDistance(error) || value === 0 || value === Infinity;
  return counted ? number(value, language) : percent(value, language);
}

type Place = (point: Point) => Omit<Label, 'text'>;

/** The labels of points: kernels by name, and knob values at both ends and on the front. */
function labelsOf({ visible, texts, language }: Shown, place: Place): readonly Label[] {
  const named = (edition: Setting['edition']): readonly Label[] =>
    joined(
      visible
        .filter(({ setting }) => setting.knob === null && setting.edition === edition)
        .map((point) => ({ text: point.setting.kernel, ...place(point) })),
    );
  const turned = linesOf(visible).flatMap((line) =>
    line.filter((point, i) => i === 0 || i === line.length - 1 || point.front),
  );
  return [
    ...named('corrected'),
    ...named(printed).map((label) => ({ ...label, text: texts.printedLabel(label.text) })),
    ...joined(
      turned.map((point) => ({ text: knobValue(point.setting, language), ...place(point) })),
    ).map(
      (label) => ({ ...label, text: label.text.replace(/, .* /u, '–') }), // a single label for the whole range
    ),
  ];
}

/** The position on a logarithmic axis, from 0 to 1. */
function share(cost: number, [least, greatest]: readonly [number, number]): number {
  const all = Math.log(greatest) - Math.log(least);
  return Math.min(1, Math.max(0, (Math.log(cost) - Math.log(least)) / all));
}

/** The meaning of the dashed line, below its right end. */
function rightPicture(shown: Shown, line: number, across: number, font: number): Placed | null {
  const { areaOfRight, texts, language } = shown;
  if (areaOfRight === null || areaOfRight === 0) return null;
  const text = texts.rightPicture(percent(areaOfRight, language));
  return { text, x: across - (widthOf(text) * font) / 2, y: line + font };
}

export function layoutOf(shown: Shown, width: number, height: number): Layout {
  const font = Math.min(20, Math.max(12, 7.5 + width / 125));
  const radius = font * 0.36;
  const [top, bottom, margin] = [font * 2.4, font * 3.8, font * 1.8];
  const inner = Math.max(height - top - bottom, 1);
  const { points, series } = shown;
  const reference = shown.areaOfRight ?? 0;
  const plotted = points.map(({ error, setting }) => ({ error, series: seriesId(setting) }));
  const axis = new ErrorAxis(
    reference > 0 ? [...plotted, { error: reference, series: '' }] : plotted,
    series.map(({ id }) => id),
    font * 1.15,
    inner,
  );
  const errorTicks = axis.ticks();
  const ticks = errorTicks.map(({ value }) => widthOf(errorTick(value, shown)));
  const left = Math.ceil((Math.max(...ticks) + 0.7) * font);
  const across = Math.max(width - left - margin, 1);
  const costs = costDomain(points.map(({ cost }) => cost));
  const heightOf = ({ error, setting }: Point): number => axis.at(error, seriesId(setting));
  const place: Place = (point) => ({
    x: share(point.cost, costs) * across,
    y: inner - heightOf(point),
  });
  const bounds = { width: across, height: inner, font: font * 0.9, radius };
  const right = rightPicture(shown, inner - axis.at(reference), across, bounds.font);
  const reserved = right === null ? [] : [right];
  return {
    width,
    height,
    font,
    radius,
    left,
    right: margin,
    top,
    bottom,
    costs,
    costTicks: logTicks(costs, across, font * 4.2),
    axis,
    errorTicks,
    heightOf,
    labels: placeLabels(labelsOf(shown, place), shown.visible.map(place), bounds, reserved),
  };
}
