import { toUtf8 } from '../base/file.js';
import { parseJson } from '../trace/check.js';
import { Refusal } from '../trace/refusal.js';
import { parseChart } from './format.js';
import type { Chart } from './format.js';

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
