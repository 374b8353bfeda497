import { svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import type { Look, Shape } from '../series.js';

/** The symbols of Plot, around 0 0. */
const outlines: Readonly<Record<Shape, string>> = {
  circle: 'M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z',
  square: 'M-4.4 -4.4h8.8v8.8h-8.8z',
  triangle: 'M0 -6.7L5.8 3.4H-5.8z',
  diamond2: 'M0 -6.2L6.2 0L0 6.2L-6.2 0z',
  star: 'M0 -7.9L1.8 -2.4H7.5L2.9 .9L4.6 6.4L0 3L-4.6 6.4L-2.9 .9L-7.5 -2.4H-1.8z',
  times: 'M-4.5 -4.5L4.5 4.5M-4.5 4.5L4.5 -4.5',
  plus: 'M-6 0h12M0 -6v12',
  asterisk: 'M0 -6.5v13M-5.6 -3.2L5.6 3.2M-5.6 3.2L5.6 -3.2',
  cross: 'M-6 -2h4v-4h4v4h4v4h-4v4h-4v-4h-4z',
  triangle2: 'M0 6.7L5.8 -3.4H-5.8z',
  wye: 'M-2 6.3V1.2L-6.4 -1.4L-4.4 -4.8L0 -2.3L4.4 -4.8L6.4 -1.4L2 1.2V6.3z',
  hexagon: 'M0 -6L5.2 -3V3L0 6L-5.2 3V-3z',
};

/** A series' symbol, 28 x 18, with a line if a knob is varied, or the text is the printed one. */
export function symbol(
  { color, shape, isFilled, scale }: Look,
  hasLine: boolean,
): SVGTemplateResult {
  const dashes = shape === 'times' ? '5 4' : 'none';
  const fill = isFilled ? color : 'var(--panel)';
  return svg`<g transform="translate(14 9)" stroke=${color} stroke-width="2" fill=${fill}>
    ${hasLine ? svg`<path d="M-14 0H14" stroke-dasharray=${dashes} />` : ''}
    <path d=${outlines[shape]} transform="scale(${scale})" stroke-width=${2 / scale} />
  </g>`;
}
