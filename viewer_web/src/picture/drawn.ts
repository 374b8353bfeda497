import { nothing, svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import type { Frame } from './frame.js';
import type { Shape } from './shapes.js';
import { labelSize } from './still.js';
import type { Label } from './still.js';
import { polygonThing } from '../algorithm/pointed.js';

/** A shape on the page. */
export function drawn({ look, d, color, fill, thing }: Shape): SVGTemplateResult {
  if (fill !== undefined) return svg`<path class=${look} d=${d} .style=${`fill: ${fill}`} />`;
  return svg`<path class=${look} d=${d} stroke=${color ?? nothing} data-thing=${thing ?? nothing} />`;
}

/** Labels in a text size independent of the zoom; polygons can be pointed at by their names. */
export function labels(all: readonly Label[], { scale }: Frame): readonly SVGTemplateResult[] {
  const size = labelSize / scale;
  return all.map(
    ({ text, of, at: [x, y] }) =>
      svg`<text class="label" data-thing=${of === undefined ? nothing : polygonThing(of)} x=${x} y=${y} font-size=${size}>${text}</text>`,
  );
}
