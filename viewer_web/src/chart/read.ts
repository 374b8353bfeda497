import { parseJson } from '../trace/parse.js';
import { Refusal } from '../trace/refusal.js';
import { parseChart } from './format.js';
import type { Chart } from './format.js';

/** Thousands of scenes; more would only keep the page busy. */
const mostBytes = 64e6;

/** Reads a chart; what is wrong with it is a `Refusal`. */
export async function readChart(file: Blob): Promise<Chart> {
  if (file.size > mostBytes) throw new Refusal('', 'tooLarge');
  const bytes = await file.arrayBuffer();
  let text;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new Refusal('', 'notUtf8');
  }
  return parseChart(parseJson(text));
}

/** The block of data that the program fills in; `null` in the page as it was built. */
export function embeddedChart(page: Document): Chart | null {
  const block = page.getElementById('vidno-chart');
  const data = block === null ? null : parseJson(block.textContent);
  return data === null ? null : parseChart(data);
}
