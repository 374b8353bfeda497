import { isLanguage } from '../language/language.js';
import type { Language } from '../language/language.js';
import { costs, errors } from './format.js';
import type { Cost, ErrorMeasure } from './format.js';
import { allSeries, front, printed } from './series.js';

/** The reader's choices, as the page's address stores them behind `#`. */
export interface Choice {
  readonly language: Language | null;
  /** A subject, or all subjects of a kind. An unknown view means the first one; so does an unknown axis. */
  readonly view: string | null;
  readonly cost: Cost | null;
  readonly error: ErrorMeasure | null;
  /** The series beside the main points. An unknown one means none, as does one that the view lacks. */
  readonly series: string | null;
}

const addable: readonly string[] = [...allSeries.map(({ id }) => id), printed, front];

export function parseChoice(hash: string): Choice {
  const fields = new URLSearchParams(hash.replace(/^#/, ''));
  const language = fields.get('lang');
  return {
    language: isLanguage(language) ? language : null,
    view: fields.get('view'),
    cost: costs.find((cost) => cost === fields.get('cost')) ?? null,
    error: errors.find((error) => error === fields.get('error')) ?? null,
    series: addable.find((id) => id === fields.get('series')) ?? null,
  };
}

export function formatChoice({ language, view, cost, error, series }: Choice): string {
  const fields = new URLSearchParams();
  if (language !== null) fields.set('lang', language);
  if (view !== null) fields.set('view', view);
  if (cost !== null) fields.set('cost', cost);
  if (error !== null) fields.set('error', error);
  if (series !== null) fields.set('series', series);
  return `#${fields.toString()}`;
}
