import type { Edition } from './editions.js';
import type { Detail, Method } from './events.js';

export interface Area {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Polygon {
  readonly id: string;
  readonly color: string;
  /** Polygons of one face are parts of it: no line is drawn where they meet. */
  readonly face?: string | undefined;
  readonly vertices: readonly (readonly [number, number, number])[];
}

/** A column, and the height over it; null where the surface has no point, so that the curve has a gap. */
export type CurveSample = readonly [x: number, y: number | null];

/** From left to right, at least two. */
export type Curve = readonly CurveSample[];

export interface Scene {
  readonly name: string;
  readonly area: Area;
  readonly background: string;
  readonly polygons: readonly Polygon[];
  readonly byId: ReadonlyMap<string, Polygon>;
  /** From the nearest to the farthest; null for a scene of polygons. A scene of curves has no polygons. */
  readonly curves: readonly Curve[] | null;
}

export interface Header {
  readonly method: Method;
  readonly edition: Edition;
  readonly kernel: string;
  readonly detail: Detail;
  readonly scene: Scene;
}

/** The header of a trace as the library writes it. */
interface Written extends Omit<Header, 'scene'> {
  readonly scene: {
    readonly name?: string;
    readonly window: Area;
    readonly background?: string;
    readonly polygons?: readonly Polygon[];
    readonly curves?: readonly Curve[];
  };
}

export function headerOf(text: string): Header {
  const { method, edition, kernel, detail, scene } = JSON.parse(text) as Written;
  const { name = '', window: area, background = '#ffffff', polygons = [], curves = null } = scene;
  const byId = new Map(polygons.map((polygon) => [polygon.id, polygon]));
  return {
    ...{ method, edition, kernel, detail },
    scene: { name, area, background, polygons, byId, curves },
  };
}
