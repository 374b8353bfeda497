/** A line of a name beside a point. */
export interface Line {
  readonly text: string;
  readonly bold: boolean;
}

/** The name of a point, or of several at the same place, in pixels from the top left. */
export interface Name {
  readonly x: number;
  readonly y: number;
  readonly lines: readonly Line[];
}

/** A line of text where it is drawn: `x` is its left end, or its right one; `y` is its middle. */
export interface Placed extends Line {
  readonly x: number;
  readonly y: number;
  readonly end: 'left' | 'right';
}

/** A line from a point to its name. */
export interface Stem {
  readonly x: number;
  readonly from: number;
  readonly to: number;
}

export interface Names {
  readonly texts: readonly Placed[];
  readonly stems: readonly Stem[];
}

export interface Bounds {
  readonly width: number;
  readonly top: number;
  readonly bottom: number;
  readonly font: number;
  /** The extent of a point's symbol. */
  readonly radius: number;
}

export interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The distance from one line of text to the next, in ems. */
export const lineHeight = 1.3;

/** An estimate of a text's width in ems, in the page's fonts. */
export function widthOf(text: string): number {
  const narrow = text.match(/[ ,.:filjt\u00a0]/gu)?.length ?? 0;
  const wide = text.match(/[%×∞mwшщжмюыфШЩЖМЮФW]/gu)?.length ?? 0;
  return narrow * 0.34 + wide * 0.95 + (text.length - narrow - wide) * 0.63;
}

/** The width of a name in ems. */
export function widthOfLines(lines: readonly Line[]): number {
  return Math.max(0, ...lines.map(({ text, bold }) => widthOf(text) * (bold ? 1.08 : 1)));
}

/** A text in lines of at most this many ems, as far as its spaces allow. */
export function wrapped(text: string, most: number): readonly string[] {
  const lines: string[] = [];
  for (const word of text.split(' ')) {
    const last = lines.at(-1);
    const longer = `${last ?? ''} ${word}`;
    if (last !== undefined && widthOf(longer) <= most) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

const overlap = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

export const around = (x: number, y: number, radius: number): Box => ({
  left: x - radius,
  right: x + radius,
  top: y - radius,
  bottom: y + radius,
});

/** The lines of a name, beginning at a height, to the right or to the left of a place. */
function linesAt(
  { lines }: Name,
  x: number,
  top: number,
  font: number,
  end: Placed['end'],
): readonly Placed[] {
  return lines.map((line, i) => ({
    ...line,
    x,
    y: top + (i + 0.5) * lineHeight * font,
    end,
  }));
}

/**
 * The names of points on one line hang below it on stems, the rightmost at the top, each to the right of its stem: so
 * no stem crosses a name. Returns the names, and the height that they take.
 */
export function flags(
  names: readonly Name[],
  { font, radius }: Pick<Bounds, 'font' | 'radius'>,
): Names & { readonly height: number } {
  const gap = font * 0.4;
  const first = radius * 2;
  const hung: { readonly left: number; readonly bottom: number }[] = [];
  const texts: Placed[] = [];
  const stems: Stem[] = [];
  for (const name of [...names].sort((a, b) => b.x - a.x)) {
    const right = name.x + gap * 2 + widthOfLines(name.lines) * font;
    const below = hung.filter(({ left }) => left < right).map(({ bottom }) => bottom);
    const top = Math.max(first, ...below);
    const bottom = top + (name.lines.length * lineHeight + 0.15) * font;
    texts.push(...linesAt(name, name.x + gap, name.y + top, font, 'left'));
    stems.push({ x: name.x, from: name.y + radius, to: name.y + bottom - font * 0.3 });
    hung.push({ left: name.x - gap / 2, bottom });
  }
  const height = Math.max(first, ...hung.map(({ bottom }) => bottom));
  return { texts, stems, height };
}

/** The possible places of a name: beside its point, and ever farther above and below on a stem. */
function* spots(name: Name, { top, bottom, font, radius }: Bounds): Generator<Names> {
  const { x, y, lines } = name;
  const tall = lines.length * lineHeight * font;
  const aside = radius * 1.9;
  const sides = [
    ['left', 1],
    ['right', -1],
  ] as const;
  for (const [end, way] of sides) {
    yield { texts: linesAt(name, x + way * aside, y - tall / 2, font, end), stems: [] };
  }
  for (let far = radius * 2; far < bottom - top; far += font / 2) {
    for (const [end, way] of sides) {
      const beside = x + way * font * 0.4;
      const up = y - far - tall;
      yield {
        texts: linesAt(name, beside, up, font, end),
        stems: [{ x, from: y - radius, to: up + font * 0.3 }],
      };
      yield {
        texts: linesAt(name, beside, y + far, font, end),
        stems: [{ x, from: y + radius, to: y + far + tall - font * 0.3 }],
      };
    }
  }
}

export function boxOf({ text, bold, x, y, end }: Placed, font: number): Box {
  const width = widthOfLines([{ text, bold }]) * font;
  const left = end === 'left' ? x : x - width;
  const half = (lineHeight * font) / 2;
  return { left, right: left + width, top: y - half, bottom: y + half };
}

const stemBox = ({ x, from, to }: Stem): Box => ({
  left: x - 1,
  right: x + 1,
  top: Math.min(from, to),
  bottom: Math.max(from, to),
});

/**
 * Places names in their order where they cover no point, nothing of what is `taken`, and no other name. One that finds no
 * place is left out. A stem may pass a point, since points may lie close together.
 */
export function placeNames(
  names: readonly Name[],
  points: readonly Pick<Name, 'x' | 'y'>[],
  taken: readonly Box[],
  bounds: Bounds,
): Names {
  const { width, top, bottom, font, radius } = bounds;
  const dots = points.map(({ x, y }) => around(x, y, radius));
  const inside = (box: Box): boolean =>
    box.left >= 0 && box.right <= width && box.top >= top && box.bottom <= bottom;
  const boxes = [...taken];
  const isFree = (box: Box): boolean => inside(box) && !boxes.some((other) => overlap(box, other));
  const placed: { readonly texts: Placed[]; readonly stems: Stem[] } = { texts: [], stems: [] };
  for (const name of names) {
    for (const { texts, stems } of spots(name, bounds)) {
      const [of, from] = [texts.map((text) => boxOf(text, font)), stems.map(stemBox)];
      const covers = of.some((box) => dots.some((dot) => overlap(box, dot)));
      if (covers || ![...of, ...from].every(isFree)) continue;
      boxes.push(...of, ...from);
      placed.texts.push(...texts);
      placed.stems.push(...stems);
      break;
    }
  }
  return placed;
}
