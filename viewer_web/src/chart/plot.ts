import {
  axisX,
  axisY,
  dot,
  gridX,
  gridY,
  line,
  plot,
  pointer,
  rect,
  ruleY,
  text,
  tip,
} from '@observablehq/plot';
import type { Markish, TipOptions } from '@observablehq/plot';
import { costTick, errorTick } from './layout.js';
import type { Layout } from './layout.js';
import { frontOf, linesOf } from './points.js';
import type { Point } from './points.js';
import { look, printed, seriesId } from './series.js';
import type { Shown } from './shown.js';
import { pointLines } from './words.js';

const color = ({ setting }: Point): string => look(setting).color;
const isPrinted = ({ setting }: Point): boolean => setting.edition === printed;
const cost = (point: Point): number => point.cost;

const fill = (point: Point): string =>
  look(point.setting).isFilled ? color(point) : 'var(--panel)';

function bands({ axis, costs }: Layout): readonly Markish[] {
  const [x1, x2] = costs;
  const found = [{ y1: 0, y2: axis.zeroBand }];
  if (axis.infiniteBand < axis.height) found.push({ y1: axis.infiniteBand, y2: axis.height });
  return [rect(found, { x1, x2, y1: 'y1', y2: 'y2', fill: 'var(--band)' })];
}

function axes(shown: Shown, layout: Layout): readonly Markish[] {
  const { texts, cost: measure, error, view } = shown;
  const { costTicks, errorTicks, font } = layout;
  const costs = texts.costs[measure];
  const decades = errorTicks.filter(({ value }) => value > 0 && value < Infinity);
  const values = new Map(errorTicks.map(({ at, value }) => [at, value]));
  return [
    gridX(costTicks, { stroke: 'var(--line)', strokeOpacity: 1 }),
    gridY(
      decades.map(({ at }) => at),
      { stroke: 'var(--line)', strokeOpacity: 1 },
    ),
    axisX(costTicks, {
      // Plot would not apply a tick format to all ticks of a logarithmic axis.
      text: (value: number) => costTick(value, shown),
      label: view.name === null ? costs.ratioAxis : costs.axis,
      labelArrow: 'right',
      labelOffset: font * 3,
    }),
    axisY([...values.keys()], {
      tickFormat: (at: number) => errorTick(values.get(at) ?? 0, shown),
      label: texts.errors[error].axis,
      labelArrow: 'up',
      tickSize: 0,
    }),
  ];
}

/** A staircase from the left of the plot, with a step down at each point that is more accurate than all cheaper ones. */
function frontLine({ front }: Shown, { axis, costs, heightOf }: Layout): Markish {
  const steps = front.filter((point) => frontOf(front).has(point));
  const [first, last] = [steps[0], steps.at(-1)];
  const places = steps.map((point) => [point.cost, heightOf(point)] as const);
  if (first !== undefined) places.unshift([first.cost, axis.height]);
  if (last !== undefined) places.push([costs[1], heightOf(last)]);
  return line(places, {
    curve: 'step-after',
    stroke: 'var(--front)',
    strokeWidth: 4,
    strokeOpacity: 0.4,
  });
}

function rightLine({ areaOfRight }: Shown, { axis }: Layout): readonly Markish[] {
  if (areaOfRight === null || areaOfRight === 0) return [];
  const style = { stroke: 'var(--ink)', strokeWidth: 1.5, strokeDasharray: '7 5' };
  return [ruleY([axis.at(areaOfRight)], style)];
}

function marks(shown: Shown, layout: Layout): readonly Markish[] {
  const { radius: r, heightOf: y, font, left, top } = layout;
  const { visible } = shown;
  const lines = linesOf(visible).flat();
  const z = ({ setting }: Point): string => seriesId(setting);
  const drawn = { x: cost, y, z, stroke: color, strokeWidth: 2 };
  return [
    line(
      lines.filter((point) => !isPrinted(point)),
      drawn,
    ),
    line(lines.filter(isPrinted), { ...drawn, strokeDasharray: '5 4' }),
    frontLine(shown, layout),
    ...rightLine(shown, layout),
    dot(visible, {
      x: cost,
      y,
      r: { value: ({ setting }: Point) => look(setting).scale * r, scale: null },
      symbol: (point: Point) => (isPrinted(point) ? 'times' : look(point.setting).shape),
      rotate: ({ setting }: Point) => (look(setting).shape === 'triangle2' ? 180 : 0),
      stroke: color,
      strokeWidth: 2,
      fill,
    }),
    dot(
      visible.filter(({ front }) => front),
      { x: cost, y, r: r * 2, stroke: 'var(--front)', strokeWidth: 2.5 },
    ),
    text(layout.labels, {
      x: { value: (label: { x: number }) => label.x + left, scale: null },
      y: { value: (label: { y: number }) => label.y + top, scale: null },
      text: 'text',
      fontSize: font * 0.9,
      fill: 'var(--ink)',
      stroke: 'var(--panel)',
      strokeWidth: 7,
    }),
  ];
}

/** The tip of the point under the mouse, and that of the point chosen by keyboard. */
function tips(shown: Shown, layout: Layout, chosen: Point | null): readonly Markish[] {
  const { heightOf: y, radius } = layout;
  const place = { x: cost, y };
  const ring = { r: radius * 2, fill: 'var(--ink)', fillOpacity: 0.25, stroke: 'var(--ink)' };
  const options: TipOptions = {
    title: (point: Point) => pointLines(point, shown).join('\n'),
    lineWidth: 60,
    lineHeight: 1.3,
    textPadding: 10,
    stroke: 'var(--soft)',
  };
  const points = chosen === null ? [] : [chosen];
  return [
    dot(shown.visible, pointer({ ...place, ...ring })),
    tip(shown.visible, pointer({ ...place, ...options })),
    dot(points, { ...place, ...ring }),
    tip(points, { ...place, ...options }),
  ];
}

/** The plot. Plot's own style sheet would violate the page's policy, so its rules are in the component's style. */
export function drawPlot(shown: Shown, layout: Layout, chosen: Point | null): SVGSVGElement {
  const { width, height, left, right, top, bottom, costs, axis, font } = layout;
  const drawn = plot({
    width,
    height,
    marginLeft: left,
    marginRight: right,
    marginTop: top,
    marginBottom: bottom,
    style: { fontSize: `${font}px`, fontFamily: 'inherit' },
    x: { type: 'log', domain: costs, clamp: true },
    y: { domain: [0, axis.height] },
    marks: [
      ...bands(layout),
      ...axes(shown, layout),
      ...marks(shown, layout),
      ...tips(shown, layout, chosen),
    ],
  });
  if (!(drawn instanceof SVGSVGElement)) throw new Error('The plot is no picture.');
  drawn.querySelector('style')?.remove();
  // The table of the front gives the same in words, and the live text one point at a time.
  drawn.setAttribute('aria-hidden', 'true');
  return drawn;
}
