import { eventsOf, numberOf } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { Instance } from './instance.js';
import type { Basics, LinesFound } from './instance.js';

/** The exports of vidno.wasm for reading; `trace/wasm/live.cpp` documents them. */
interface Exports extends Basics {
  open(): number;
  read(): number;
}

/** Limits: the library searches a list of polygons from its beginning, and stores a pixel for each one of the area. */
const mostPolygons = 4096;
const mostPixels = 2 ** 24;

/**
 * A run that the library reads in a tenth of the time of `Run`. It only accepts lines with possible events, written as a
 * run writes them. `Run` reads the other lines, and describes their errors.
 */
export class QuickRun {
  private readonly isToldHere: readonly boolean[];

  private constructor(
    private readonly instance: Instance<Exports>,
    { method }: Header,
  ) {
    const told: boolean[] = [];
    for (const name of eventsOf[method]) told[numberOf.get(name) ?? 0] = true;
    this.isToldHere = told;
  }

  /** A run with this first line; null for a run that the library does not read, or not quickly. */
  static of(module: WebAssembly.Module, first: Uint8Array, header: Header): QuickRun | null {
    const { polygons, area } = header.scene;
    if (polygons.length > mostPolygons || area.width * area.height > mostPixels) return null;
    const instance = new Instance<Exports>(module);
    instance.ask(first);
    return instance.exports.open() === 0 ? null : new QuickRun(instance, header);
  }

  /** The lines of a block up to the first that `Run` has to read. */
  take(block: Uint8Array): LinesFound {
    const { instance } = this;
    instance.ask(block);
    instance.exports.read();
    const { starts, names } = instance.lines();
    const strange = names.findIndex((name) => this.isToldHere[name] !== true);
    if (strange < 0) return { starts, names };
    return { starts: starts.slice(0, strange + 1), names: names.slice(0, strange) };
  }
}
