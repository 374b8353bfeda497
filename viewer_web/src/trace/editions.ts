import type { Method } from './events.js';

/** The usual mistakes, and the methods that each concerns. */
export const mistakes = {
  'one-list': ['warnock'],
  'depths-not-cleared': ['zbuffer'],
  'clip-order-reversed': ['warnock'],
  'y-flipped': ['warnock', 'zbuffer'],
  'depth-sign-reversed': ['warnock', 'zbuffer'],
  'boundary-outside': ['warnock', 'zbuffer'],
  'integer-division': ['warnock'],
  'surround-kept': ['warnock'],
} as const satisfies Readonly<Record<string, readonly Method[]>>;

export type Mistake = keyof typeof mistakes;
export type Edition = 'corrected' | 'printed' | Mistake;

export const editions: readonly Edition[] = [
  'corrected',
  'printed',
  ...(Object.keys(mistakes) as Mistake[]),
];

export const isMistake = (edition: Edition): edition is Mistake => edition in mistakes;

/** Whether a method has an edition. */
export function has(method: Method, edition: Edition): boolean {
  const concerned: readonly Method[] | null = isMistake(edition) ? mistakes[edition] : null;
  return concerned?.includes(method) ?? true;
}

type Names = Readonly<Record<Edition, string>>;

/** Of the names of all editions, those that a method has. */
export function namesFor(method: Method, names: Names): Readonly<Record<string, string>> {
  const own = editions.filter((edition) => has(method, edition));
  return Object.fromEntries(own.map((edition) => [edition, names[edition]] as const));
}
