import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { cornerThing, edgeThing } from '../algorithm/pointed.js';
import { none, parts } from './question.js';
import type { Asks, Of, Option } from './question.js';
import { isItsNote, sayNone, sayNote, sayValue } from './say.js';
import type { Corner } from '../trace/values.js';
import type { View } from '../algorithm/view.js';
import { polygonName } from '../elements/parts.js';

/** The thing that lights up in the picture with an option. */
function thingOf(of: Of, value: string): string | typeof nothing {
  if (of === 'corner') return cornerThing(value as Corner);
  return of === 'edge' ? edgeThing(Number(value)) : nothing;
}

/** The label of an option, or of what a part is about. */
export function valueName(of: Of, option: Option, view: View): TemplateResult {
  const note = sayNote(option, view.language);
  return html`${nameOf(of, option.value, view)}
  ${note === null ? nothing : html`<span class="note number">${note}</span>`}`;
}

function nameOf(of: Of, value: string, view: View): TemplateResult {
  if (of === 'polygon') return polygonName(value, view);
  const said = isItsNote(of) ? nothing : sayValue(of, value, view.language);
  return html`<span data-thing=${thingOf(of, value)}>${said}</span>`;
}

/** An option of a part; for no polygon, the meaning of that. */
export function optionName(asks: Asks, option: Option, view: View): TemplateResult {
  if (option.value === none) return html`${sayNone(asks, view.language)}`;
  return valueName(parts[asks][1], option, view);
}
