import type { Detail } from '../trace/events.js';
import type { Area } from '../trace/header.js';

/** The texts of the editor. */
export interface SceneTexts {
  readonly scene: string;
  readonly edit: string;
  readonly how: string;
  /** The same where some vertices lie outside the picture. */
  readonly howOutside: string;
  readonly run: string;
  readonly method: string;
  readonly kernel: string;
  readonly edition: string;
  readonly detail: string;
  readonly details: Readonly<Record<Detail, string>>;
  readonly check: string;
  readonly undo: string;
  readonly redo: string;
  readonly draw: string;
  readonly drawing: string;
  readonly drawHere: string;
  readonly clear: string;
  readonly clearHint: string;
  readonly save: string;
  readonly saveHint: string;
  readonly link: string;
  readonly linkHint: string;
  readonly linkCopied: string;
  readonly page: string;
  readonly pageHint: string;
  readonly pageSaved: string;
  readonly discard: Readonly<
    Record<'text' | 'stay' | 'save' | 'discard', string> & { title: (name: string) => string }
  >;
  readonly area: string;
  readonly areaFields: Readonly<Record<keyof Area, string>>;
  readonly background: string;
  readonly polygons: string;
  readonly order: string;
  readonly colorOf: (id: string) => string;
  readonly nameOf: (id: string) => string;
  readonly needsName: string;
  readonly isTaken: (id: string) => string;
  readonly cornersOf: (id: string) => string;
  readonly earlier: (id: string) => string;
  readonly later: (id: string) => string;
  readonly remove: (id: string) => string;
  readonly corner: (id: string, n: number, x: number, y: number, z: number) => string;
  readonly coordinate: (axis: 'x' | 'y' | 'z', n: number) => string;
  readonly follows: string;
  readonly split: (n: number) => string;
  readonly removeCorner: (n: number) => string;
  readonly refused: (polygon: string | null, reason: string) => string;
  /** The same for a surface's formula. */
  readonly formula: (reason: string) => string;
  readonly stands: string;
  /** A place in the text of a file. */
  readonly at: (line: number, column: number) => string;
  readonly missing: (key: string) => string;
  /** The library's reasons for refusal that the page words differently. */
  readonly reasons: Readonly<Record<string, string>>;
  readonly more: (n: number) => string;
}
