import { eventsOf, numberOf } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { Instance } from './instance.js';
import type { Basics, LinesFound } from './instance.js';

/** What of vidno.wasm reads; `trace/wasm/live.cpp` documents it. */
interface Exports extends Basics {
  open(): number;
  read(): number;
}

/** The library looks through a list of polygons from its beginning, and has a pixel for each of the area. */
const mostPolygons = 4096;
const mostPixels = 2 ** 24;

/**
 * A run as the library reads it, in a tenth of the time that `Run` takes, which knows no more: each line is an event that can
 * happen, written as a run writes it. `Run` takes the others, and says what is wrong with them.
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

  /** By the first line; null for a run that the library does not read, or not quickly. */
  static of(module: WebAssembly.Module, first: Uint8Array, header: Header): QuickRun | null {
    const { polygons, area } = header.scene;
    if (polygons.length > mostPolygons || area.width * area.height > mostPixels) return null;
    const instance = new Instance<Exports>(module);
    instance.ask(first);
    return instance.exports.open() === 0 ? null : new QuickRun(instance, header);
  }

  /** The lines of a block up to the first that `Run` has to look at. */
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
