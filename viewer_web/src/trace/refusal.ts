/** The page's reasons for refusing a file, with the arguments of the message; the wording is in `i18n`. */
export interface Reasons {
  // A value does not fit the format.
  number: [found: string];
  notNegative: [found: string];
  whole: [found: string];
  between: [least: string, greatest: string, found: string];
  bool: [found: string];
  text: [found: string];
  oneOf: [values: string, found: string];
  newerFormat: [format: string, found: string];
  olderFormat: [format: string, found: string];
  list: [found: string];
  object: [found: string];
  missing: [];
  // A story does not fit its lesson.
  noSuchPin: [name: string];
  noSuchRun: [name: string];
  noWebAddress: [found: string];
  // A file or a list has nothing in it, or is no text.
  emptyFile: [];
  emptyList: [];
  notJson: [found: string];
  notUtf8: [];
  tooLarge: [];
}
export type Reason = keyof Reasons;

/** `path` is the place in the line, as in `scene.polygons[2].color`. */
export class Refusal<K extends Reason = Reason> extends Error {
  readonly details: Reasons[K];

  constructor(
    readonly path: string,
    readonly reason: K,
    ...details: Reasons[K]
  ) {
    super(`${path} ${reason} ${details.join(' ')}`);
    this.details = details;
  }
}

export function isRefusal(error: unknown): error is Refusal {
  return error instanceof Refusal;
}

/** A short description of a value for a message; a long value is shortened. */
export function describe(value: unknown): string {
  const text = value === undefined ? '' : JSON.stringify(value);
  return text.length > 40 ? `${text.slice(0, 39)}…` : text;
}
