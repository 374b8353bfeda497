import { nothing, svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import type { Shape } from '../picture/shapes.js';

/** A shape as the page shows it. */
export function drawn({ look, d, color, thing }: Shape): SVGTemplateResult {
  return svg`<path class=${look} d=${d} stroke=${color ?? nothing} data-thing=${thing ?? nothing} />`;
}
