import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseChart } from '../chart/format.js';
import type { Chart, Run, Scene } from '../chart/format.js';

const file = fileURLToPath(new URL('../../test-data/chart.json', import.meta.url));

/** Two ordinary scenes and a degenerate one, run in every way that there is. */
export const sampleText = readFileSync(file, 'utf8');
export const sample: Chart = parseChart(JSON.parse(sampleText));

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

export function runOf(fields: Partial<Run>): Run {
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

export function sceneOf(runs: readonly Run[], fields: Partial<Scene> = {}): Scene {
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
