import type { Edition } from '../trace/editions.js';
import type { Method } from '../trace/events.js';
import type { Language } from '../language/language.js';
import type { Promised } from './maker.js';
import { usual } from './options.js';
import type { Options } from './options.js';

type Bilingual = Readonly<Record<Language, string>>;

interface NamedRun {
  readonly method: Method;
  readonly kernel: string;
  readonly edition: Edition;
}

/** The library's description of a failure; `trace/wasm/live.cpp` documents it. */
interface FailureFile {
  readonly title: Bilingual;
  readonly why: Bilingual;
  readonly remedy: Bilingual;
  /** What is visible at the step. */
  readonly there: Bilingual;
  readonly source: string;
  /** Null if no single step shows it. */
  readonly step: number | null;
  readonly pixel: readonly [number, number] | null;
  readonly fails: NamedRun;
  readonly holds: NamedRun;
}

/** A scene on which a run fails, ready to be shown. */
export interface Failure extends Omit<FailureFile, 'fails' | 'holds'> {
  /** The text of its scene. */
  readonly scene: string;
  readonly fails: Options;
  readonly holds: Options;
  /** The scene of the correct run, if it is another one. */
  readonly holdsScene: string | null;
}

export type Found = { readonly failure: Failure } | { readonly messages: string };

const optionsOf = (run: NamedRun): Options => ({ ...usual, ...run });

function failureOf(text: string, made: string): Failure {
  const { fails, holds, ...others } = JSON.parse(made) as FailureFile;
  const file = JSON.parse(text) as { scene: unknown; holds: { scene?: unknown } };
  const own = file.holds.scene;
  return {
    ...others,
    scene: JSON.stringify(file.scene),
    fails: optionsOf(fails),
    holds: optionsOf(holds),
    holdsScene: own === undefined ? null : JSON.stringify(own),
  };
}

/** Reads a file of a failure and finds the step where it shows, with the page's library. */
export async function failureIn(text: string, library: Promised<'failure'>): Promise<Found> {
  const { made, messages } = await library.ask(text);
  return made === null ? { messages } : { failure: failureOf(text, made) };
}
