import { Instance } from './instance.js';
import type { Basics } from './instance.js';

/** The functions of replay.wasm; `trace/wasm/replays.cpp` documents them. A trace is named by its number. */
interface Exports extends Basics {
  trace_open(): number;
  trace_close(trace: number): void;
  trace_append(trace: number): number;
  trace_finish(trace: number): number;
  trace_header(trace: number): void;
  trace_shortened(trace: number): void;
  trace_length(trace: number): number;
  trace_names(trace: number): number;
  trace_line(trace: number, step: number): void;
  trace_values(trace: number, step: number): void;
  trace_sentence(trace: number, step: number, language: number): void;
  trace_notes(trace: number, step: number, language: number): void;
  trace_note(trace: number, step: number, language: number): void;
  has_note(event: number): number;
  trace_decision(trace: number, step: number, language: number): void;
  trace_verdict(trace: number, comparison: number, wrong: number, language: number): void;
  history_open(trace: number, x: number, y: number): number;
  history_close(history: number): void;
  history_read(history: number, until: number): void;
  history_sentence(history: number, step: number, outcome: number, language: number): void;
  history_why(history: number, step: number, isLater: number, language: number): void;
  history_holding(history: number): void;
  history_reason(history: number, polygon: number, language: number): void;
  painted_at(trace: number): number;
  divided_at(trace: number): number;
  is_ground(trace: number): number;
  pixel(trace: number, x: number, y: number): number;
  painter(trace: number, x: number, y: number): number;
  pixel_rows(trace: number, first: number, count: number): number;
  row_repeats(trace: number, y: number): number;
  has_depths(trace: number): number;
  depth(trace: number, x: number, y: number): number;
  depth_text(trace: number, x: number, y: number): void;
  windows(
    trace: number,
    x: number,
    y: number,
    width: number,
    height: number,
    least: number,
  ): number;
}

/** The library in the page's own thread, which answers at once. It holds traces and the states of their runs. */
export type Engine = Instance<Exports>;

/** The browser, or the policy of the page, forbids WebAssembly. */
export class NoWebAssembly extends Error {}

let started: Engine | null = null;
let starting: Promise<void> = Promise.reject(new Error('the engine was not started'));
starting.catch(() => undefined);

/** Starts the engine; nothing can be replayed before. */
export function startEngine(module: Promise<WebAssembly.Module>): void {
  starting = module
    .then((compiled) => {
      started = new Instance<Exports>(compiled);
    })
    .catch((error: unknown) => {
      throw new NoWebAssembly(String(error));
    });
  starting.catch(() => undefined);
}

/** Resolved when the engine has started. Rejected with `NoWebAssembly` where the page may not use it. */
export const ready = (): Promise<void> => starting;

/** Requires that the engine has started. */
export function engine(): Engine {
  if (started === null) throw new Error('the engine was not started');
  return started;
}
