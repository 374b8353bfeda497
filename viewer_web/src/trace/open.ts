import { follow } from './trace.js';
import type { Trace } from './trace.js';
import type { News } from './read.js';
import { starterOf } from './start-worker.js';
import code from './worker.js?code';

const startWorker = starterOf(code);

/** Milliseconds: to show growth more often would only keep the page busy. */
const pause = 200;

/** What the page does as a file is read. */
export interface Readers {
  /** There is more of the trace: at first its beginning, at last all of it. */
  grown(trace: Trace): void;
  /** The file is no trace, or could not be read. */
  failed(error: unknown): void;
}

/** Reads a file in a worker. Gives the way to stop that. */
export function openTrace(file: Blob, { grown, failed }: Readers): () => void {
  const worker = startWorker();
  const stop = (): void => {
    worker.onmessage = null;
    worker.terminate();
  };
  let trace: Trace | null = null;
  let told = -Infinity;
  const take = (news: News): void => {
    trace = follow(trace, news);
    if (trace === null || news.is === 'header') return;
    if (trace.complete) stop();
    else if (performance.now() < told + pause) return;
    grown(trace);
    told = performance.now();
  };
  worker.onmessage = ({ data }: MessageEvent<News>): void => {
    try {
      take(data);
    } catch (error) {
      stop();
      failed(error);
    }
  };
  const fail = (event: Event): void => {
    stop();
    failed(event);
  };
  worker.addEventListener('error', fail);
  worker.addEventListener('messageerror', fail);
  worker.postMessage(file);
  return stop;
}
