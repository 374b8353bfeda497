import type { Language } from '../language/language.js';
import { usual } from '../run/options.js';
import type { Options } from '../run/options.js';
import { packed, wordOf } from '../run/packed.js';
import type { Setting } from './series.js';

/** The file that a run used: a surface with the samples of the run. */
export function fileOfRun(file: object, { knob, value }: Setting): string {
  if (knob === 'samples') return JSON.stringify({ ...file, samples: value, tolerance: undefined });
  if (knob === 'tolerance') return JSON.stringify({ ...file, samples: 2, tolerance: value });
  return JSON.stringify(file);
}

/** Links from a run on the chart to the page of traces. */
export interface Links {
  readonly replay: string;
  /** The run beside the exact run; null for the exact run itself. */
  readonly compare: string | null;
}

/** Why there is no link: the page cannot make the run, or the file is too large for an address. */
export type Unlinked = 'window' | 'large';

function linkTo(page: URL, fields: Readonly<Record<string, string>>): string {
  const link = new URL(page);
  link.hash = new URLSearchParams(fields).toString();
  return link.href;
}

/** The links to the run of a scene file on the page of traces. */
export async function linksOf(
  { method, kernel, edition, knob }: Setting,
  file: string,
  page: URL,
  lang: Language,
): Promise<Links | Unlinked> {
  if (knob === 'window') return 'window';
  const scene = await packed(file);
  if (scene === null) return 'large';
  const options: Options = { ...usual, method, kernel, edition };
  const run = wordOf(options);
  const exact = wordOf({ ...options, edition: 'corrected', kernel: 'exact' });
  const fields = { lang, run, scene };
  return {
    replay: linkTo(page, fields),
    compare: run === exact ? null : linkTo(page, { ...fields, with: exact }),
  };
}
