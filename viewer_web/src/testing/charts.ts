import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { sceneChart } from '../chart/scene-format.js';
import type { Scene, SceneRun } from '../chart/scene-format.js';
import { surfaceChart } from '../chart/surface-format.js';
import type { CurveRun, Surface } from '../chart/surface-format.js';

const textOf = (name: string): string =>
  readFileSync(fileURLToPath(new URL(`../../test-data/${name}`, import.meta.url)), 'utf8');

/** Two ordinary scenes and a degenerate one, run in every possible way. */
export const sampleText = textOf('chart.json');
export const sample = sceneChart(JSON.parse(sampleText), '');

/** The lesson's peak between two samples, and a slope, run in every possible way. */
export const surfaceText = textOf('surface-chart.json');
export const surfaceSample = surfaceChart(JSON.parse(surfaceText), '');

const nowhere = { time: [], operations: [], bits: [] };
const counts = {
  windows: 0,
  boxes: 0,
  depths: 0,
  orientations: 0,
  comparisons: 10,
  intersections: 0,
  rows: 0,
  edges: 0,
};

export function runOf(fields: Partial<SceneRun>): SceneRun {
  return {
    method: 'zbuffer',
    kernel: 'double',
    edition: 'corrected',
    window: 1,
    knob: null,
    value: null,
    complete: true,
    seconds: 0.001,
    time: 1,
    operations: 10,
    bits: 530,
    counts,
    wrongPixels: 0,
    area: 0,
    decisions: 10,
    wrongDecisions: 0,
    depthUlps: 0,
    front: nowhere,
    ...fields,
  };
}

export function sceneOf(runs: readonly SceneRun[], fields: Partial<Scene> = {}): Scene {
  return {
    name: 'Square',
    kind: 'ordinary',
    unsteady: 0,
    pixels: 100,
    polygons: 1,
    area: 0,
    runs,
    ...fields,
  };
}

export function curveRunOf(fields: Partial<CurveRun>): CurveRun {
  return {
    method: 'floating-horizon',
    kernel: 'double',
    edition: 'corrected',
    knob: null,
    value: null,
    seconds: 0.001,
    time: 1,
    operations: 10,
    samples: 6,
    counts: { visibilities: 8, horizons: 2, steps: 0, crossings: 0 },
    wrongColumns: 0,
    height: 0,
    decisions: 10,
    wrongDecisions: 0,
    front: { time: [], operations: [], samples: [] },
    ...fields,
  };
}

export function surfaceOf(runs: readonly CurveRun[], fields: Partial<Surface> = {}): Surface {
  return { name: 'Hill', curves: 2, columns: 50, runs, ...fields };
}
