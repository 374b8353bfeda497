import {
  axisX,
  axisY,
  dot,
  gridX,
  gridY,
  line,
  link,
  plot,
  pointer,
  rect,
  ruleY,
  text,
  tip,
} from '@observablehq/plot';
import type { ChannelValueSpec as Channel, Markish, TipOptions } from '@observablehq/plot';
import { costTick, errorTick } from './layout.js';
import type { Names, Placed, Stem } from './labels.js';
import type { Layout } from './layout.js';
import { byCost, frontOf, linesOf } from './points.js';
import type { Point } from './points.js';
import { front, look, printed, seriesId, settingId } from './series.js';
import type { Shown } from './shown.js';
import { pointLines } from './words.js';

const isPrinted = ({ setting }: Point): boolean => setting.edition === printed;
const cost = (point: Point): number => point.cost;

/** The line that divides right from wrong, and that of the right points. */
function lines({ axis }: Layout): readonly Markish[] {
  return [
    rect([{}], { y1: 0, y2: axis.divide, fill: 'var(--right-wash)', ariaDescription: 'right' }),
    ruleY([axis.divide], { stroke: 'var(--ink)', strokeWidth: 1.5, ariaDescription: 'divide' }),
    ruleY([axis.right], { stroke: 'var(--soft)', strokeWidth: 1, ariaDescription: 'zero' }),
  ];
}

function axes(shown: Shown, layout: Layout): readonly Markish[] {
  const { texts, cost: measure, error, view } = shown;
  const { costTicks, errorTicks, font } = layout;
  const costs = texts.costs[measure];
  const decades = errorTicks.slice(1);
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
      labelAnchor: 'left',
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
function frontLine(points: readonly Point[], { axis, costs, heightOf }: Layout): Markish {
  const steps = [...points].sort(byCost).filter((point) => frontOf(points).has(point));
  const [first, last] = [steps[0], steps.at(-1)];
  const places = steps.map((point) => [point.cost, heightOf(point)] as const);
  if (first !== undefined) places.unshift([first.cost, axis.height]);
  if (last !== undefined) places.push([costs[1], heightOf(last)]);
  return line(places, {
    curve: 'step-after',
    stroke: 'var(--ink)',
    strokeOpacity: 0.4,
    strokeWidth: 4,
  });
}

/** How strongly the main points are drawn beside an added series. */
const faded = 0.4;

function dots(points: readonly Point[], layout: Layout, style: Style): readonly Markish[] {
  const { radius: r, heightOf: y } = layout;
  return [
    dot(points, {
      ariaDescription: `${style.name} points`,
      x: cost,
      y,
      r: { value: ({ setting }: Point) => look(setting).scale * r, scale: null },
      symbol: (point: Point) => (isPrinted(point) ? 'times' : look(point.setting).shape),
      rotate: ({ setting }: Point) => (look(setting).shape === 'triangle2' ? 180 : 0),
      stroke: style.color,
      strokeWidth: 2,
      fill: (point: Point) => (look(point.setting).isFilled ? style.color(point) : 'var(--panel)'),
      opacity: style.opacity,
    }),
  ];
}

interface Style {
  readonly name: string;
  readonly color: (point: Point) => string;
  readonly opacity: number;
}

/** The names, each with its stem. */
function namesOf({ texts, stems }: Names, layout: Layout, { name, opacity }: Style): Markish[] {
  const { left, top, font } = layout;
  const across = (of: (item: Stem & Placed) => number): Channel => ({
    value: (item: Stem & Placed) => of(item) + left,
    scale: null,
  });
  const down = (of: (item: Stem & Placed) => number): Channel => ({
    value: (item: Stem & Placed) => of(item) + top,
    scale: null,
  });
  const written = (bold: boolean, end: Placed['end']): Markish =>
    text(
      texts.filter((each) => each.bold === bold && each.end === end),
      {
        ariaDescription: `${name} names`,
        x: across(({ x }) => x),
        y: down(({ y }) => y),
        text: 'text',
        textAnchor: end === 'left' ? 'start' : 'end',
        fontSize: font * 0.95,
        fontWeight: bold ? 700 : 400,
        fill: 'var(--ink)',
        opacity,
      },
    );
  return [
    link(stems, {
      ariaDescription: `${name} stems`,
      x1: across(({ x }) => x),
      x2: across(({ x }) => x),
      y1: down(({ from }) => from),
      y2: down(({ to }) => to),
      stroke: 'var(--soft)',
      opacity,
    }),
    written(false, 'left'),
    written(false, 'right'),
    written(true, 'left'),
    written(true, 'right'),
  ];
}

function marks(shown: Shown, layout: Layout, color: Style['color']): readonly Markish[] {
  const { radius, heightOf: y, font } = layout;
  const { main, added, answer, chosenSeries } = shown;
  const turned = linesOf(added).flat();
  const z = ({ setting }: Point): string => `${seriesId(setting)} ${setting.edition}`;
  const drawn = { x: cost, y, z, stroke: color, strokeWidth: 2 };
  const ofMain = { name: 'main', color, opacity: chosenSeries === null ? 1 : faded };
  const ofAdded = { name: 'added', color, opacity: 1 };
  const id = answer.cheapest && settingId(answer.cheapest.setting);
  return [
    ...namesOf(layout.main, layout, ofMain),
    ...namesOf(layout.added, layout, ofAdded),
    ...namesOf({ texts: layout.words, stems: [] }, layout, { ...ofAdded, name: 'word' }),
    ...dots(main, layout, ofMain),
    dot(
      main.filter(({ setting }) => settingId(setting) === id),
      {
        ariaDescription: 'cheapest',
        x: cost,
        y,
        r: radius * 2,
        stroke: 'var(--ink)',
        strokeWidth: font / 6,
        opacity: ofMain.opacity,
      },
    ),
    ...(chosenSeries === front
      ? [
          frontLine(
            shown.points.filter((point) => point.front),
            layout,
          ),
        ]
      : [
          line(
            turned.filter((point) => !isPrinted(point)),
            drawn,
          ),
          line(turned.filter(isPrinted), { ...drawn, strokeDasharray: '5 4' }),
        ]),
    ...dots(added, layout, ofAdded),
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

/** What the reader points at, and what paper shows. */
interface Drawn {
  readonly chosen: Point | null;
  /** Whether to draw without colours. */
  readonly inInk: boolean;
}

/** The plot. Plot's own style sheet would violate the page's policy, so its rules are in the component's style. */
export function drawPlot(shown: Shown, layout: Layout, { chosen, inInk }: Drawn): SVGSVGElement {
  const { width, height, left, right, top, bottom, costs, axis, font } = layout;
  const color = ({ setting }: Point): string => (inInk ? 'var(--ink)' : look(setting).color);
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
      ...lines(layout),
      ...axes(shown, layout),
      ...marks(shown, layout, color),
      ...(inInk ? [] : tips(shown, layout, chosen)),
    ],
  });
  if (!(drawn instanceof SVGSVGElement)) throw new Error('The plot is no picture.');
  drawn.querySelector('style')?.remove();
  // The table of the points gives the same in words, and the live text one point at a time.
  drawn.setAttribute('aria-hidden', 'true');
  return drawn;
}
