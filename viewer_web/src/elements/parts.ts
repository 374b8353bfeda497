import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { classMap } from 'lit/directives/class-map.js';
import { polygonThing } from '../algorithm/pointed.js';
import type { N } from '../trace/values.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';

/** A colour as a small square. */
export function swatch(color: string): TemplateResult {
  return html`<span class="swatch" .style=${`background: ${color}`}></span>`;
}

/** A polygon's colour and id. It lights up with the polygon wherever that is shown. */
export function polygonName(id: string, { header, pointed }: View): TemplateResult {
  const color = header.scene.byId.get(id)?.color;
  const thing = polygonThing(id);
  return html`<span class=${thing === pointed ? 'pointed' : ''} data-thing=${thing}
    >${color === undefined ? nothing : swatch(color)}${id}</span
  >`;
}

/** Whether a step gave a value. A value that is merely no longer known was not changed. */
export const isSet = <T>(now: T | null, old: T | null): boolean => now !== null && now !== old;

/** A named value; `changed` marks what this step changed. */
export function value(
  name: string,
  shown: unknown,
  changed: boolean,
  kind: 'wide' | '' = '',
): TemplateResult {
  return html`<div class=${kind}>
    <dt>${name}</dt>
    <dd class=${classMap({ changed })}>${shown}</dd>
  </div>`;
}

/** A number of the trace, shortened; pointing at it shows it in full. */
export function numberCell(now: N, before: N | undefined, view: View): TemplateResult {
  const changed = now !== before;
  const { short, whole } = numbersOf(view);
  return html`<td class=${classMap({ number: true, changed })} title=${whole(now)}>
    ${short(now)}
  </td>`;
}
