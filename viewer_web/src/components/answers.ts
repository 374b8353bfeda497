import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { texts } from '../i18n/index.js';
import type { Language } from '../i18n/language.js';
import { cornerThing, edgeThing } from '../pointed.js';
import type { Relation } from '../predict/asker.js';
import { none, parts } from '../predict/question.js';
import type { Asks, Of, Option, Part } from '../predict/question.js';
import type { Case } from '../time/course.js';
import type { Corner } from '../trace/values.js';
import type { View } from '../view.js';
import { polygonName } from './parts.js';

type Say = (value: string, language: Language) => string;

const itself = (value: string): string => value.replace('-', '−');

const words: Readonly<Record<Of, Say>> = {
  case: (value, language) => texts[language].strip.cases[value as Case],
  polygon: itself,
  corner: (value, language) => texts[language].places[value as Corner],
  relation: (value, language) => `${value} ${texts[language].predict.relations[value as Relation]}`,
  yes: (value, language) => texts[language].page[value === 'yes' ? 'yes' : 'no'],
  sign: itself,
  vertex: itself,
  edge: (value, language) => texts[language].predict.edge(value),
  depth: itself,
  column: (value, language) => texts[language].predict.column(value),
};

/** The right answer to a part, in words. */
export function sayRight({ asks, options, right }: Part, language: Language): string {
  const [form, of] = parts[asks];
  const say = (value: string): string => {
    if (value === none) return sayNone(asks, language);
    const note = of === 'depth' ? options.find((each) => each.value === value)?.note : undefined;
    return note ?? words[of](value, language);
  };
  if (right.length === 0) return texts[language].predict.empty;
  return form === 'row' ? right.map(itself).join(' ') : right.map(say).join(', ');
}

function sayNone(asks: Asks, language: Language): string {
  const { noPolygon } = texts[language].predict;
  return noPolygon[asks === 'wins' ? 'wins' : 'hides'];
}

/** What lights up in the picture with an option. */
function thingOf(of: Of, value: string): string | typeof nothing {
  if (of === 'corner') return cornerThing(value as Corner);
  return of === 'edge' ? edgeThing(Number(value)) : nothing;
}

/** An option as it stands beside its box, or what a part is about. */
export function valueName(of: Of, { value, note }: Option, view: View): TemplateResult {
  if (of === 'polygon') return polygonName(value, view);
  const said = of === 'depth' ? nothing : words[of](value, view.language);
  return html`<span data-thing=${thingOf(of, value)}>${said}</span> ${
      note === undefined ? nothing : html`<span class="note number">${note}</span>`
    }`;
}

/** An option of a part; where it is no polygon at all, what that means there. */
export function optionName(asks: Asks, option: Option, view: View): TemplateResult {
  if (option.value === none) return html`${sayNone(asks, view.language)}`;
  return valueName(parts[asks][1], option, view);
}
