import { plainObject } from '../trace/check.js';
import { sceneChart, sceneCosts, sceneErrors, sceneKinds, sceneKnobs } from './scene-format.js';
import type { Scene, SceneChart, SceneRun } from './scene-format.js';
import { curveCosts, curveErrors, curveKnobs, surfaceChart } from './surface-format.js';
import type { CurveRun, Surface, SurfaceChart } from './surface-format.js';

/** A chart of scenes or of surfaces. These are its subjects. */
export type Chart = SceneChart | SurfaceChart;
export type Subject = Scene | Surface;
export type Run = SceneRun | CurveRun;

/** The costs of both kinds of chart. */
export const costs = [...new Set([...sceneCosts, ...curveCosts])];
export const errors = [...new Set([...sceneErrors, ...curveErrors])];
export const knobs = [...sceneKnobs, ...curveKnobs] as const;
export const kinds = [...sceneKinds, 'surfaces'] as const;

export type Cost = (typeof costs)[number];
export type ErrorMeasure = (typeof errors)[number];
export type Knob = (typeof knobs)[number];
export type Kind = (typeof kinds)[number];

/** Parses and checks a chart as described in `trace/CHART.md`; drops unknown fields. */
export function parseChart(value: unknown): Chart {
  const ofSurfaces = Object.hasOwn(plainObject(value, ''), 'surfaces');
  return ofSurfaces ? surfaceChart(value, '') : sceneChart(value, '');
}
