/** A text beside a point. */
export interface Label {
  readonly text: string;
  readonly x: number;
  readonly y: number;
}

export interface Placed {
  readonly text: string;
  /** The middle of the text. */
  readonly x: number;
  readonly y: number;
}

export interface Bounds {
  readonly width: number;
  readonly height: number;
  readonly font: number;
  /** The extent of a point's symbol. */
  readonly radius: number;
}

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** An estimate of a text's width in ems, in the page's fonts. */
export function widthOf(text: string): number {
  const narrow = text.match(/[ ,.:filjt\u00a0]/gu)?.length ?? 0;
  const wide = text.match(/[%×∞]/gu)?.length ?? 0;
  return narrow * 0.34 + wide * 0.95 + (text.length - narrow - wide) * 0.63;
}

const overlap = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

function around(x: number, y: number, width: number, height: number): Box {
  return {
    left: x - width / 2,
    right: x + width / 2,
    top: y - height / 2,
    bottom: y + height / 2,
  };
}

/** The possible positions of a text of this size: to the right, to the left, above, below, and at the corners. */
function spots(
  { x, y }: Label,
  width: number,
  height: number,
  radius: number,
): readonly (readonly [number, number])[] {
  const aside = width / 2 + radius * 1.7;
  const apart = height / 2 + radius * 1.3;
  const slant = width / 2 + radius * 0.8;
  return [
    [x + aside, y],
    [x - aside, y],
    [x, y - apart],
    [x, y + apart],
    [x + slant, y - apart],
    [x - slant, y - apart],
    [x + slant, y + apart],
    [x - slant, y + apart],
  ];
}

/** Points at the same place have one label with all their texts, each once. */
export function joined(labels: readonly Label[]): readonly Label[] {
  const found = new Map<string, { readonly first: Label; readonly texts: Set<string> }>();
  for (const label of labels) {
    const place = `${Math.round(label.x)} ${Math.round(label.y)}`;
    const at = found.get(place) ?? { first: label, texts: new Set() };
    found.set(place, at);
    at.texts.add(label.text);
  }
  return [...found.values()].map(({ first, texts }) => ({ ...first, text: [...texts].join(', ') }));
}

/**
 * Places texts, the more important first, where they cover no point and no other text, including the `reserved` ones. A
 * text without such a place is left out.
 */
export function placeLabels(
  labels: readonly Label[],
  points: readonly Pick<Label, 'x' | 'y'>[],
  { width, height, font, radius }: Bounds,
  reserved: readonly Placed[] = [],
): readonly Placed[] {
  const taken = points.map(({ x, y }) => around(x, y, radius * 2, radius * 2));
  const placed = [...reserved];
  for (const { text, x, y } of reserved) taken.push(around(x, y, widthOf(text) * font, font));
  for (const label of labels) {
    const long = widthOf(label.text) * font;
    const spot = spots(label, long, font, radius).find(([x, y]) => {
      const box = around(x, y, long, font);
      const inside = box.left >= 0 && box.right <= width && box.top >= 0 && box.bottom <= height;
      return inside && !taken.some((other) => overlap(box, other));
    });
    if (spot === undefined) continue;
    const [x, y] = spot;
    taken.push(around(x, y, long, font));
    placed.push({ text: label.text, x, y });
  }
  return placed;
}
