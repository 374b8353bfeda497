import { fileIn } from '../base/base64.js';
import { textOf } from '../base/file.js';
import type { FailureKind } from '../language/texts.js';
import type { Language } from '../language/language.js';
import { isMistake } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';
import type { Method } from '../trace/events.js';

/** The order of the kinds in the gallery. */
export const entryKinds: readonly FailureKind[] = [
  'rounding',
  'printed',
  'mistake',
  'limit',
  'test',
];

/** The fields of an atlas file that the gallery shows; the library reads the rest. */
interface FailureFile {
  readonly title: Readonly<Record<Language, string>>;
  readonly why: Readonly<Record<Language, string>>;
  readonly remedy: Readonly<Record<Language, string>>;
  readonly scene?: unknown;
  readonly fails?: { readonly method: Method; readonly kernel: string; readonly edition: Edition };
  readonly shows?: { readonly pixel?: readonly [number, number] };
}

export interface Entry extends FailureFile {
  readonly name: string;
  /** The text of its file. */
  readonly text: string;
  readonly kind: FailureKind;
  /** Why its picture has no proof; null if it is right, or is of curves. */
  readonly unproved: Readonly<Record<Language, string>> | null;
}

/** An entry that no scene can show has a test of its own instead. */
export function kindOfEntry({ fails }: Pick<FailureFile, 'fails'>): FailureKind {
  if (fails === undefined) return 'test';
  if (isMistake(fails.edition)) return 'mistake';
  if (fails.edition !== 'corrected') return 'printed';
  // The exact kernel does not round: the failure is a limit of the method itself.
  return fails.kernel === 'exact' ? 'limit' : 'rounding';
}

/** The entries, grouped by kind, in the order of their names. */
export function entriesIn(json: string): readonly Entry[] {
  const files = JSON.parse(json) as readonly (readonly [
    name: string,
    text: string,
    unproved: Entry['unproved'],
  ])[];
  const entries = files.map(([name, text, unproved]): Entry => {
    const failure = JSON.parse(text) as FailureFile;
    return { ...failure, name, text, unproved, kind: kindOfEntry(failure) };
  });
  const place = ({ kind }: Entry): number => entryKinds.indexOf(kind);
  return [...entries].sort((one, other) => place(one) - place(other));
}

/** The atlas in the page; empty if the page was built without one. */
export async function embeddedAtlas(page: Document): Promise<readonly Entry[]> {
  const block = page.getElementById('vidno-atlas');
  return block === null ? [] : entriesIn(await textOf(fileIn(block)));
}
