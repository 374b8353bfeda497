import { fileIn } from '../base/base64.js';
import { textOf } from '../base/text-file.js';
import type { FailureKind } from '../language/atlas-texts.js';
import type { Language } from '../language/language.js';
import { isMistake } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';
import type { Method } from '../trace/events.js';

/** In the order in which they stand. */
export const entryKinds: readonly FailureKind[] = [
  'rounding',
  'printed',
  'mistake',
  'limit',
  'test',
];

/** What a file of the atlas says, as far as the gallery shows it; the library reads the rest. */
interface Told {
  readonly title: Readonly<Record<Language, string>>;
  readonly why: Readonly<Record<Language, string>>;
  readonly remedy: Readonly<Record<Language, string>>;
  readonly scene?: unknown;
  readonly fails?: { readonly method: Method; readonly kernel: string; readonly edition: Edition };
  readonly shows?: { readonly pixel?: readonly [number, number] };
}

export interface Entry extends Told {
  readonly name: string;
  /** Its file. */
  readonly text: string;
  readonly kind: FailureKind;
}

/** An entry that no scene can show has a test of its own instead. */
export function kindOfEntry({ fails }: Pick<Told, 'fails'>): FailureKind {
  if (fails === undefined) return 'test';
  if (isMistake(fails.edition)) return 'mistake';
  if (fails.edition !== 'corrected') return 'printed';
  // Nothing rounds there: the method itself does not see it.
  return fails.kernel === 'exact' ? 'limit' : 'rounding';
}

/** Those of a kind stand together, by their names. */
export function entriesIn(json: string): readonly Entry[] {
  const files = JSON.parse(json) as readonly (readonly [name: string, text: string])[];
  const entries = files.map(([name, text]): Entry => {
    const told = JSON.parse(text) as Told;
    return { ...told, name, text, kind: kindOfEntry(told) };
  });
  const place = ({ kind }: Entry): number => entryKinds.indexOf(kind);
  return [...entries].sort((one, other) => place(one) - place(other));
}

/** The atlas that the page brings along; empty if it was built without. */
export async function embeddedAtlas(page: Document): Promise<readonly Entry[]> {
  const block = page.getElementById('vidno-atlas');
  return block === null ? [] : entriesIn(await textOf(fileIn(block)));
}
