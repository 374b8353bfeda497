import code from '../app/worker.js?code';
import { read } from './read.js';
import type { News, Order } from './read.js';
import { starterOf } from './start-worker.js';
import { keep } from './trace.js';
import type { Trace } from './trace.js';

const startWorker = starterOf(code);

/** Milliseconds: to show growth more often would only keep the page busy. */
const pause = 200;

/** What the page does as a file is read. */
export interface Readers {
  /** There is more of the trace: at first its beginning, at last all of it. */
  grown(trace: Trace): void;
  /** The file is no trace, from its first event on, or could not be read. */
  failed(error: unknown): void;
}

/** A smaller file is read before the library would be there. */
const small = 2 ** 16;

/**
 * Reads a file in a worker, or here where the policy of another page allows none; by the library, where there is one and it pays.
 * Gives the way to stop that.
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
    // Told before the newest part is added: so the end of a trace always brings new steps, by which those who show it know.
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
    // Without it everything is read as well, only slower.
    const module = file.size < small ? null : await library()?.catch(() => null);
    if (!isOver) worker.postMessage({ file, library: module ?? null } satisfies Order);
  };
  void start();
  return stop;
}
