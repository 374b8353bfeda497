import code from '../app/worker.js?code';
import { read } from './read.js';
import type { News, Order } from './read.js';
import { starterOf } from './start-worker.js';
import { keep } from './trace.js';
import type { Trace } from './trace.js';

const startWorker = starterOf(code);

/** Milliseconds between reports of progress: more frequent ones would only keep the page busy. */
const pause = 200;

/** The callbacks while a file is read. */
export interface Readers {
  /** The trace has grown: first to its beginning, at last to the whole. */
  grown(trace: Trace): void;
  /** The file is not a trace, from its first event on, or could not be read. */
  failed(error: unknown): void;
}

/** A smaller file is read before the library is loaded. */
const small = 2 ** 16;

/**
 * Reads a file in a worker, or in the page if the policy of the surrounding page allows no worker. Uses the library if
 * there is one and the file is large enough. Returns a function that stops the reading.
 */
export function openTrace(
  file: Blob,
  { grown, failed }: Readers,
  library: () => Promise<WebAssembly.Module> | null = () => null,
): () => void {
  const worker = startWorker();
  let isOver = false;
  const stop = (): void => {
    isOver = true;
    worker.onmessage = null;
    worker.terminate();
  };
  let trace: Trace | null = null;
  let told = -Infinity;
  const take = (news: News): void => {
    // The report comes before the newest part is added. The end of a trace therefore always brings new steps, by which the
    // components notice it.
    if (trace !== null && trace.timeline.length > 0 && performance.now() >= told + pause) {
      if (news.is === 'part') grown(trace);
      told = performance.now();
    }
    trace = keep(trace, news);
    if (trace?.complete !== true) return;
    stop();
    grown(trace);
  };
  const fail = (error: unknown): void => {
    stop();
    failed(error);
  };
  const readHere = async (): Promise<void> => {
    worker.terminate();
    for await (const news of read(file)) {
      if (isOver) return;
      take(news);
    }
  };
  worker.onmessage = ({ data }: MessageEvent<News>): void => {
    try {
      take(data);
    } catch (error) {
      fail(error);
    }
  };
  worker.addEventListener('error', (event) => {
    if (trace === null && !isOver) void readHere().catch(fail);
    else fail(event);
  });
  worker.addEventListener('messageerror', fail);
  const start = async (): Promise<void> => {
    // Without the library everything is read as well, but more slowly.
    const module = file.size < small ? null : await library()?.catch(() => null);
    if (!isOver) worker.postMessage({ file, library: module ?? null } satisfies Order);
  };
  void start();
  return stop;
}
