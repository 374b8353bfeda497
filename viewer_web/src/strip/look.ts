import { css } from 'lit';
import { cases } from '../time/course.js';
import type { Case } from '../time/course.js';
import type { Polygon } from '../trace/header.js';

/** The dark dots of a square tile. They distinguish the cases where colours do not. */
interface Texture {
  readonly size: number;
  readonly dark: (x: number, y: number) => boolean;
}

type TextureName = Case | 'plain' | 'striped';

/** CSS pixels: the least width at which stripes are visible. */
export const stripes = 6;

const textures: Readonly<Record<TextureName, Texture>> = {
  empty: { size: 4, dark: (x, y) => x === 1 && y === 1 },
  surrounded: { size: 1, dark: () => true },
  pixel: { size: 4, dark: (x, y) => x >> 1 === y >> 1 },
  single: { size: 6, dark: (x, y) => (x + y) % 6 < 4 },
  split: { size: 4, dark: (_x, y) => y !== 0 },
  plain: { size: 1, dark: () => true },
  striped: { size: stripes, dark: (x, y) => (x - y + stripes) % stripes < 4 },
};

/** The texture in a colour, with dark dots in full and the others pale, at `ratio` device pixels per CSS pixel. */
function textureIn(name: TextureName, color: string, ratio: number): CanvasPattern | string {
  const { size, dark } = textures[name];
  if (size === 1) return color;
  const unit = Math.max(1, Math.round(ratio));
  const tile = document.createElement('canvas');
  tile.width = tile.height = size * unit;
  const context = tile.getContext('2d');
  if (context === null) return color;
  context.fillStyle = color;
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      context.globalAlpha = dark(x, y) ? 1 : 0.3;
      context.fillRect(x * unit, y * unit, unit, unit);
    }
  }
  return context.createPattern(tile, 'repeat') ?? color;
}

/** The colours of a strip; they also differ in lightness. */
export const stripColors = css`
  :host {
    --empty: #6b7686;
    --surrounded: #00796b;
    --pixel: #2563d6;
    --single: #bf6500;
    --split: #451a75;
    --level: #5361c4;
  }
  @media (prefers-color-scheme: dark) {
    :host {
      --empty: #8b96a6;
      --surrounded: #35c9b1;
      --pixel: #6ba2ff;
      --single: #f2a444;
      --split: #d0aeff;
      --level: #8391ef;
    }
  }
`;

type Fill = CanvasPattern | string;

/** The colours and textures of a strip, in the current theme of the page. */
export interface Look {
  /** Device pixels per CSS pixel. */
  readonly ratio: number;
  readonly ground: string;
  readonly ink: string;
  readonly level: string;
  readonly call: string;
  readonly wrong: string;
  readonly bookmark: string;
  readonly hit: string;
  readonly font: string;
  readonly ofCase: (name: Case) => Fill;
  readonly ofPolygon: (polygon: Polygon, index: number) => Fill;
  readonly ofCurve: (index: number) => Fill;
}

/** The look of an element by the style sheet. */
export function lookOf(element: Element, ratio: number): Look {
  const style = getComputedStyle(element);
  const color = (name: string): string => style.getPropertyValue(name).trim();
  const fills = new Map(cases.map((name) => [name, textureIn(name, color(`--${name}`), ratio)]));
  return {
    ratio,
    ground: color('--well'),
    ink: color('--ink'),
    level: color('--level'),
    call: color('--soft'),
    wrong: color('--bad'),
    bookmark: color('--accent'),
    hit: color('--accent'),
    font: `600 ${10 * ratio}px ${color('--mono')}`,
    ofCase: (name) => fills.get(name) ?? '',
    // Consecutive polygons may have the same colour.
    ofPolygon: ({ color: own }, index) =>
      textureIn(index % 2 === 0 ? 'plain' : 'striped', own, ratio),
    ofCurve: (index) => textureIn(index % 2 === 0 ? 'plain' : 'striped', color('--level'), ratio),
  };
}
