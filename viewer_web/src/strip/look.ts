import { css } from 'lit';
import { cases } from '../time/course.js';
import type { Case } from '../time/course.js';
import type { Polygon } from '../trace/header.js';
import { textureIn } from './textures.js';

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
