import { toUtf8 } from '../base/file.js';
import { parseJson, plainObject } from '../trace/check.js';
import { Refusal } from '../trace/refusal.js';
import { sceneChart, sceneCosts, sceneErrors, sceneKinds } from './scene-format.js';
import type { Scene, SceneChart, SceneRun, sceneKnobs } from './scene-format.js';
import { curveCosts, curveErrors, surfaceChart } from './surface-format.js';
import type { CurveKnob, CurveRun, Surface, SurfaceChart } from './surface-format.js';

/** A chart of scenes or of surfaces. These are its subjects. */
export type Chart = SceneChart | SurfaceChart;
export type Subject = Scene | Surface;
export type Run = SceneRun | CurveRun;

/** The costs of both kinds of chart. */
export const costs = [...new Set([...sceneCosts, ...curveCosts])];
export const errors = [...new Set([...sceneErrors, ...curveErrors])];
export const kinds = [...sceneKinds, 'surfaces'] as const;

export type Cost = (typeof costs)[number];
export type ErrorMeasure = (typeof errors)[number];
export type Knob = (typeof sceneKnobs)[number] | CurveKnob;
export type Kind = (typeof kinds)[number];

/** Parses and checks a chart as described in `trace/CHART.md`; drops unknown fields. */
function parseChart(value: unknown): Chart {
  const ofSurfaces = Object.hasOwn(plainObject(value, ''), 'surfaces');
  return ofSurfaces ? surfaceChart(value, '') : sceneChart(value, '');
}

/** Enough for thousands of scenes; more would only keep the page busy. */
const mostBytes = 64e6;

/** Reads a chart; throws a `Refusal` for an invalid one. */
export async function readChart(file: Blob): Promise<Chart> {
  if (file.size > mostBytes) throw new Refusal('', 'tooLarge');
  const bytes = await new Response(file.stream().pipeThrough(toUtf8())).arrayBuffer();
  let text;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new Refusal('', 'notUtf8');
  }
  return parseChart(parseJson(text));
}

/** The page of traces, if its address is known: a chart that the program wrote to disk has none. */
export function embeddedReplay(page: Document): URL | null {
  const block = page.getElementById('vidno-replay');
  const address = block === null ? null : parseJson(block.textContent);
  if (typeof address !== 'string' || !URL.canParse(address, page.baseURI)) return null;
  const found = new URL(address, page.baseURI);
  return found.protocol === new URL(page.baseURI).protocol ? found : null;
}

/** The block of data that the program fills in; `null` in the page as built. */
export function embeddedChart(page: Document): Chart | null {
  const block = page.getElementById('vidno-chart');
  const data = block === null ? null : parseJson(block.textContent);
  return data === null ? null : parseChart(data);
}
