import { Unpacked } from '../trace/unpacked.js';
import { ready } from './engine.js';
import { Opening, Unreadable } from './trace.js';
import type { Trace } from './trace.js';

/** Milliseconds between reports of progress: more frequent ones would only keep the page busy. */
const pause = 200;
/** Milliseconds of reading after which the page may respond. */
const atOnce = 12;
/** The bytes that are read at once. */
const piece = 2 ** 17;
/** A longer text would fill the memory of the page. */
const mostBytes = 2 ** 30;
/** The library holds a line in memory until it ends. No real line is so long. */
const longestLine = 2 ** 26;
const newline = 0x0a;

/** The callbacks while a file is read. */
export interface Readers {
  /** The trace has grown: first to its beginning, at last to the whole. */
  grown(trace: Trace): void;
  /** The file is not a trace, from its first event on, or could not be read. */
  failed(error: unknown): void;
}

const breath = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

function* piecesOf(part: Uint8Array): Generator<Uint8Array> {
  for (let from = 0; from < part.length; from += piece) yield part.subarray(from, from + piece);
}

/**
 * Reads a trace, plain or gzip. Yields it before each part and at its end, so that the end brings new steps, by which the
 * components notice it. Throws Unreadable for a file that is not a trace, from its first event on.
 */
export async function* read(
  file: Blob,
  most = mostBytes,
  longest = longestLine,
): AsyncGenerator<Trace> {
  await ready();
  const opening = new Opening();
  const unpacked = new Unpacked(file);
  let bytes = 0;
  let line = 0;
  for await (const part of unpacked.pieces()) {
    for (const next of piecesOf(part)) {
      const { trace } = opening;
      if (trace !== null) {
        trace.read = unpacked.read / file.size;
        yield trace;
      }
      bytes += next.length;
      const end = next.lastIndexOf(newline);
      line = end < 0 ? line + next.length : next.length - 1 - end;
      if (line > longest && trace === null) throw new Unreadable('a line of more than 64 MiB');
      if ((bytes > most || line > longest) && trace !== null) {
        trace.end('limit');
        yield trace;
        return;
      }
      opening.append(next);
      if (opening.trace?.shortened?.why === 'wrong') {
        yield opening.broken();
        return;
      }
    }
  }
  if (unpacked.isBroken && bytes === 0) throw new Unreadable('broken gzip data');
  yield opening.finish();
}

/** Reads a file between other work of the page. Returns a function that stops the reading. */
export function openTrace(file: Blob, { grown, failed }: Readers): () => void {
  let isOver = false;
  const readOn = async (): Promise<void> => {
    let [shown, rested] = [-Infinity, performance.now()];
    for await (const trace of read(file)) {
      if (isOver) return;
      const now = performance.now();
      if (trace.complete || (trace.timeline.length > 0 && now >= shown + pause)) {
        grown(trace);
        shown = now;
      }
      if (now < rested + atOnce) continue;
      await breath();
      rested = performance.now();
    }
  };
  void readOn().catch((error: unknown) => {
    if (!isOver) failed(error);
  });
  return () => {
    isOver = true;
  };
}
