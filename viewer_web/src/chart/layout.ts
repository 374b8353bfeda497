import { ErrorAxis, costDomain } from './axes.js';
import type { Tick } from './axes.js';
import { boxOf, flags, placeNames, widthOf, widthOfLines, wrapped } from './labels.js';
import type { Line, Name, Names, Placed } from './labels.js';
import { number, percent, ratio } from './numbers.js';
import { byCost, linesOf } from './points.js';
import type { Point } from './points.js';
import { front, printed, settingId } from './series.js';
import type { Shown } from './shown.js';
import { isDistance } from './subject.js';
import { logTicks } from './ticks.js';
import { groupName, knobValue } from './words.js';

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
  /** The words above and below the line that divides right from wrong. */
  readonly words: readonly Placed[];
  readonly main: Names;
  readonly added: Names;
}

export function costTick(value: number, { cost, view, language }: Shown): string {
  const counted = cost !== 'time' && view.name !== null;
  return counted ? number(value, language) : ratio(value, language);
}

export function errorTick(value: number, { error, language }: Shown): string {
  const counted = isDistance(error) || value === 0 || value === Infinity;
  return counted ? number(value, language) : percent(value, language);
}

type Place = (point: Point) => Pick<Name, 'x' | 'y'>;

/** Points that cannot be told apart, since their symbols nearly cover each other. */
function together(points: readonly Point[], place: Place, apart: number): readonly Point[][] {
  const groups: Point[][] = [];
  for (const point of [...points].sort(byCost)) {
    const { x, y } = place(point);
    const group = groups.find(([first]) => {
      const at = first && place(first);
      return at !== undefined && Math.hypot(at.x - x, at.y - y) < apart;
    });
    if (group === undefined) groups.push([point]);
    else group.push(point);
  }
  return groups;
}

/** For each method or sampling of points at one place, a name that lists the kernels; then whether it is the cheapest. */
function linesOfNames(group: readonly Point[], shown: Shown, most: number): readonly Line[] {
  const { texts, answer } = shown;
  const kernels = new Map<string, string[]>();
  for (const { setting } of group) {
    const name = groupName(setting, shown);
    kernels.set(name, [...(kernels.get(name) ?? []), setting.kernel]);
  }
  const { cheapest } = answer;
  const marked =
    cheapest !== null &&
    group.some(({ setting }) => settingId(setting) === settingId(cheapest.setting));
  const names = [...kernels].flatMap(([name, of]) =>
    wrapped(`${name} ·\u00a0${of.join(', ')}`, most),
  );
  return [
    ...names.map((text) => ({ text, bold: false })),
    ...(marked ? wrapped(texts.cheapestMark, most).map((text) => ({ text, bold: true })) : []),
  ];
}

/** What is written beside an added point: the value of its knob, otherwise its kernel. */
function addedText({ setting }: Point, { texts, chosenSeries, language }: Shown): string {
  if (setting.knob !== null) return knobValue(setting, language);
  const isOfPrinted = chosenSeries === printed || chosenSeries === front;
  return isOfPrinted ? `${texts.methods[setting.method]} · ${setting.kernel}` : setting.kernel;
}

/** The names of added points: at both ends of a knob and on the front; others without a knob. */
function namesOfAdded(shown: Shown, place: Place, apart: number): readonly Name[] {
  const { added, chosenSeries } = shown;
  const turned = linesOf(added).flatMap((line) =>
    line.filter(
      (point, i) => i === 0 || i === line.length - 1 || point.front || chosenSeries === 'front',
    ),
  );
  const plain = added.filter(({ setting }) => setting.knob === null);
  return together([...plain, ...turned], place, apart).flatMap((group) => {
    const [first] = group;
    if (first === undefined) return [];
    const texts = [...new Set(group.map((point) => addedText(point, shown)))];
    const [least, last] = [texts[0] ?? '', texts.at(-1) ?? ''];
    const text =
      first.setting.knob === null ? texts.join(', ') : least === last ? least : `${least}–${last}`;
    return [{ ...place(first), lines: [{ text, bold: false }] }];
  });
}

/** The position on a logarithmic axis, from 0 to 1. */
function share(cost: number, [least, greatest]: readonly [number, number]): number {
  const all = Math.log(greatest) - Math.log(least);
  return Math.min(1, Math.max(0, (Math.log(cost) - Math.log(least)) / all));
}

/** A range this many times as long, on a logarithmic axis. */
function extended([least, greatest]: readonly [number, number], times: number): [number, number] {
  const from = Math.log10(least);
  return [least, 10 ** Math.min(from + (Math.log10(greatest) - from) * times, 300)];
}

/** The layout at a size; `font` is that of the axes, in pixels. */
export function layoutOf(
  shown: Shown,
  width: number,
  height: number,
  font = Math.min(20, Math.max(12, 7.5 + width / 125)),
): Layout {
  const radius = font * 0.36;
  const small = font * 0.95;
  const [top, bottom] = [font * 2.4, font * 3.8];
  const inner = Math.max(height - top - bottom, 1);
  const { main, visible, least, texts } = shown;
  const axisAbove = (below: number): ErrorAxis =>
    new ErrorAxis(
      visible.map(({ error }) => error),
      least,
      { below, word: font * 2.3, tick: font * 1.9 },
      inner,
    );
  const ticks = axisAbove(0)
    .ticks()
    .map(({ value }) => widthOf(errorTick(value, shown)));
  const left = Math.ceil((Math.max(...ticks) + 0.7) * font);
  const all = Math.max(width - left - font * 0.5, 1);
  const ends = costDomain(visible.map(({ cost }) => cost));

  // The names of the right points hang to the right of them, so the axis goes on until all of them fit.
  const most = Math.floor((all * 0.45) / small);
  const isRight = ({ error }: Point): boolean => error <= least;
  const apart = radius * 1.5;
  const onLine: Place = ({ cost }) => ({ x: share(cost, ends) * all * 0.7, y: 0 });
  const right = together(main.filter(isRight), onLine, apart).map((group) => ({
    at: share(group[0]?.cost ?? 1, ends),
    lines: linesOfNames(group, shown, most),
  }));
  const fits = right.map(({ at, lines }) => (all - (widthOfLines(lines) + 1) * small) / at);
  const across = Math.max(Math.min(all - font, ...fits), 1);
  const costs = extended(ends, all / across);
  const hung = (y: number): readonly Name[] =>
    right.map(({ at, lines }) => ({ x: at * across, y, lines }));
  const bounds = { width: all, top: 0, bottom: 0, font: small, radius };
  const axis = axisAbove(flags(hung(0), bounds).height + font * 0.3);

  const heightOf = ({ error }: Point): number => axis.at(error);
  const place: Place = (point) => ({
    x: share(point.cost, costs) * all,
    y: inner - heightOf(point),
  });
  const divide = inner - axis.divide;
  const word = { bold: true, x: font * 0.3, end: 'left' } as const;
  const words = [
    { ...word, text: texts.wrong, y: divide - font * 0.8 },
    { ...word, text: texts.right, y: divide + font * 0.8 },
  ];
  const flagged = flags(hung(inner - axis.right), bounds);
  const wrong = together(
    main.filter((point) => !isRight(point)),
    place,
    apart,
  ).flatMap((group) =>
    group.slice(0, 1).map((first) => ({
      ...place(first),
      lines: linesOfNames(group, shown, most * 1.5),
    })),
  );
  const points = visible.map(place);
  const taken = words.map((word) => boxOf(word, font));
  const above = placeNames(wrong, points, taken, { ...bounds, bottom: divide });
  const named = [...flagged.texts, ...above.texts].map((text) => boxOf(text, small));
  const added = placeNames(namesOfAdded(shown, place, apart), points, [...taken, ...named], {
    ...bounds,
    bottom: inner - axis.right - radius,
  });
  return {
    width,
    height,
    font,
    radius,
    left,
    right: width - left - all,
    top,
    bottom,
    costs,
    // A number at the very end would be cut off.
    costTicks: logTicks(costs, all, font * 4.2).filter(
      (value) => share(value, costs) * all < all - font * 1.8,
    ),
    axis,
    errorTicks: axis.ticks(),
    heightOf,
    words,
    main: {
      texts: [...flagged.texts, ...above.texts],
      stems: [...flagged.stems, ...above.stems],
    },
    added,
  };
}
