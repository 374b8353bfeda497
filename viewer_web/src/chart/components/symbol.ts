import { svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import type { Shape } from '../series.js';

/** As Plot draws them, about 0 0. */
const outlines: Readonly<Record<Shape, string>> = {
  circle: 'M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z',
  square: 'M-4.4 -4.4h8.8v8.8h-8.8z',
  triangle: 'M0 -6.7L5.8 3.4H-5.8z',
  diamond2: 'M0 -6.2L6.2 0L0 6.2L-6.2 0z',
  star: 'M0 -7.9L1.8 -2.4H7.5L2.9 .9L4.6 6.4L0 3L-4.6 6.4L-2.9 .9L-7.5 -2.4H-1.8z',
  times: 'M-4.5 -4.5L4.5 4.5M-4.5 4.5L4.5 -4.5',
};

/** A series' symbol on its line, 28 x 18. */
export function symbol(shape: Shape, color: string, fill: string): SVGTemplateResult {
  const dashes = shape === 'times' ? '5 4' : 'none';
  return svg`<g transform="translate(14 9)" stroke=${color} stroke-width="2" fill=${fill}>
    ${shape === 'star' ? '' : svg`<path d="M-14 0H14" stroke-dasharray=${dashes} />`}
    <path d=${outlines[shape]} />
  </g>`;
}
