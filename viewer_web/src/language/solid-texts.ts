import type { ViewName } from '../solid/turn.js';

/** The texts of the 3D view. */
export interface SolidTexts {
  readonly solid: string;
  readonly title: string;
  readonly how: string;
  readonly turn: string;
  readonly views: Readonly<Record<ViewName, string>>;
  readonly missing: string;
  readonly depths: (far: string, near: string) => string;
  readonly window: (window: string) => string;
  readonly corners: (depths: string) => string;
  readonly plane: (polygon: string, depths: string) => string;
  readonly clip: string;
  readonly point: (point: string, depths: string) => string;
  readonly noPolygon: string;
  readonly scanline: (row: string, edges: string) => string;
  readonly span: (from: string, to: string) => string;
  readonly pixel: (pixel: string, own: string, stored: string) => string;
}
