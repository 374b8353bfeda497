import { isLanguage } from '../language/language.js';
import type { Language } from '../language/language.js';
import { costs, errors } from './format.js';
import type { Cost, ErrorMeasure } from './format.js';
import { allSeries, printed } from './series.js';

/** The reader's choices, as the page's address stores them behind `#`. */
export interface Choice {
  readonly language: Language | null;
  /** A subject, or all subjects of a kind. An unknown view means the first one; so does an unknown axis. */
  readonly view: string | null;
  readonly cost: Cost | null;
  readonly error: ErrorMeasure | null;
  readonly hidden: ReadonlySet<string>;
}

const toggles: readonly string[] = [...allSeries.map(({ id }) => id), printed];

export function parseChoice(hash: string): Choice {
  const fields = new URLSearchParams(hash.replace(/^#/, ''));
  const language = fields.get('lang');
  const hidden = (fields.get('hide') ?? '').split(' ');
  return {
    language: isLanguage(language) ? language : null,
    view: fields.get('view'),
    cost: costs.find((cost) => cost === fields.get('cost')) ?? null,
    error: errors.find((error) => error === fields.get('error')) ?? null,
    hidden: new Set(toggles.filter((id) => hidden.includes(id))),
  };
}

export function formatChoice({ language, view, cost, error, hidden }: Choice): string {
  const fields = new URLSearchParams();
  if (language !== null) fields.set('lang', language);
  if (view !== null) fields.set('view', view);
  if (cost !== null) fields.set('cost', cost);
  if (error !== null) fields.set('error', error);
  if (hidden.size > 0) fields.set('hide', toggles.filter((id) => hidden.has(id)).join(' '));
  return `#${fields.toString()}`;
}
