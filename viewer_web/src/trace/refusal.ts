/** The reasons for refusing a file or an event, with the arguments of the message; the wording is in `i18n`. */
export interface Reasons {
  // A value does not fit the format.
  number: [found: string];
  notNegative: [found: string];
  kernelNumber: [found: string];
  answer: [found: string];
  whole: [found: string];
  between: [least: string, greatest: string, found: string];
  bool: [found: string];
  text: [found: string];
  color: [found: string];
  label: [found: string];
  kernel: [found: string];
  hash: [found: string];
  oneOf: [values: string, found: string];
  newerFormat: [format: string, found: string];
  olderFormat: [format: string, found: string];
  list: [found: string];
  listOf: [length: string, found: string];
  object: [found: string];
  missing: [];
  unknownKey: [];
  twice: [];
  // A story does not fit its lesson.
  noSuchPin: [name: string];
  noSuchRun: [name: string];
  noWebAddress: [found: string];
  // A line is not allowed at its place.
  emptyFile: [];
  emptyLine: [];
  emptyList: [];
  notJson: [found: string];
  noEvent: [name: string, method: string];
  tooDetailed: [name: string, detail: string];
  afterEnd: [];
  eventCount: [said: string, found: string];
  notUtf8: [];
  longLine: [];
  notGzip: [];
  tooLarge: [];
  // An event cannot happen at its place.
  noSuchPolygon: [id: string];
  outsideArea: [];
  resultOf: [procedure: string, frame: string];
  emptyStack: [];
  notTop: [];
  noWindow: [];
  rootNeedsList: [];
  partHasList: [];
  notInList: [id: string];
  notLast: [id: string];
  noDepths: [];
  noClip: [];
  clipCount: [said: string, found: string];
  noPolygon: [];
  notInS: [edge: string];
  notInAel: [edge: string];
  twiceInAel: [edge: string];
  notAnOrder: [];
  depthCount: [depths: string, pixels: string];
  // Curves.
  fewSamples: [];
  notRight: [];
  noSuchCurve: [curve: string];
  notOfCurve: [segment: string];
  // Regions.
  noList: [];
  notTopList: [];
  noListInHand: [];
  notNextPiece: [polygon: string];
  behindCount: [said: string, found: string];
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
