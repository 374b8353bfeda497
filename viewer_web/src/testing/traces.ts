import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { read } from '../replay/open.js';
import { Opening, Unreadable } from '../replay/trace.js';
import type { Trace } from '../replay/trace.js';
import { drawsCurves } from '../trace/events.js';
import type { Detail, Event, Method } from '../trace/events.js';
import type { Header } from '../trace/header.js';

const directory = fileURLToPath(new URL('../../test-data/', import.meta.url));

export const traceNames: readonly string[] = readdirSync(directory).filter((name) =>
  name.endsWith('.jsonl'),
);

export function textOf(name: string): string {
  return readFileSync(directory + name, 'utf8');
}

/** The trace in a file with this text, up to a wrong line, as a page shows it. At most `most` bytes are read. */
export async function keptOf(
  text: string | Uint8Array<ArrayBuffer>,
  most?: number,
): Promise<Trace> {
  let trace: Trace | null = null;
  for await (const part of read(new Blob([text]), most)) trace = part;
  if (trace === null) throw new Error('a file without a trace');
  return trace;
}

/** The trace in a file in which no line is wrong. */
export async function traceOf(
  text: string | Uint8Array<ArrayBuffer>,
  most?: number,
): Promise<Trace> {
  const trace = await keptOf(text, most);
  const { shortened } = trace;
  if (shortened?.why !== 'wrong') return trace;
  throw new Unreadable(shortened.reason, shortened.path, shortened.line);
}

/** The header in the first line of a trace. */
export function parseHeader(header: object): Header {
  const opening = new Opening();
  opening.append(new TextEncoder().encode(linesOf(header)));
  if (opening.trace === null) throw new Error('a line without a header');
  return opening.trace.header;
}

/** Two curves over 8 columns that cross. */
const twoCurves = {
  format: 'vidno-surface/1',
  name: 'Two curves',
  window: { x: 0, y: 0, width: 8, height: 8 },
  curves: [
    [
      [0, 2],
      [4, 3],
      [7, 2],
    ],
    [
      [0, 3],
      [4, 1],
      [7, 5],
    ],
  ],
};

/** The header of an 8 x 8 scene with the polygons A and B, or with two curves. */
export function headerOf(method: Method, detail: Detail = 'signs'): object {
  const square = (id: string, color: string): object => ({
    id,
    color,
    vertices: [
      [0, 0, 0.5],
      [8, 0, 0.5],
      [8, 8, 0.5],
      [0, 8, 0.5],
    ],
  });
  return {
    format: 'vidno-trace/1',
    method,
    edition: 'corrected',
    kernel: 'double',
    detail,
    scene:
      method === 'floating-horizon'
        ? twoCurves
        : {
            format: 'vidno-scene/1',
            name: 'Two squares',
            window: { x: 0, y: 0, width: 8, height: 8 },
            background: '#ffffff',
            polygons: [square('A', '#112233'), square('B', '#445566')],
          },
  };
}

/** On this scene, the first window is pushed on the stack and popped from it. */
export const push: Event<'push'> = {
  e: 'push',
  at: 'W3',
  window: [0, 0, 8, 8],
  apl: [
    ['A', false],
    ['B', false],
  ],
};
export const pop: Event<'pop'> = { e: 'pop', at: 'W5', window: [0, 0, 8, 8] };

export function linesOf(...values: readonly unknown[]): string {
  return values.map((value) => `${JSON.stringify(value)}\n`).join('');
}

/** A trace of these events as text, including its last line. */
export function textWith(header: object, events: readonly Event[]): string {
  const { method } = header as { method: Method };
  const result = drawsCurves(method) ? 'lines' : 'picture';
  const end = { end: { events: events.length, [result]: `sha256:${'0'.repeat(64)}` } };
  return linesOf(header, ...events, end);
}
