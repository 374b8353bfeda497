import { nothing, svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import type { Frame } from './frame.js';
import type { Shape } from './shapes.js';
import { labelSize, swatchOf } from './still.js';
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
  return all.map((label) => {
    const { text, of, color, at } = label;
    const [x, y] = at;
    const swatch = swatchOf(label, size);
    const thing = of === undefined ? nothing : polygonThing(of);
    return svg`${
      swatch === null
        ? nothing
        : svg`<rect class="of-name" data-thing=${thing} x=${x + swatch.x} y=${y - swatch.size / 2} width=${swatch.size} height=${swatch.size} .style=${`fill: ${color ?? ''}`} />`
    }<text class="label" data-thing=${thing} x=${x + (swatch?.shift ?? 0)} y=${y} font-size=${size}>${text}</text>`;
  });
}
