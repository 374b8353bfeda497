import type { Trace } from '../replay/trace.js';
import { eventNames, kinds } from '../trace/events.js';

const atOnce = 2048;
const key = '"polygon":"';

const mayName = eventNames.map((name) => kinds[name].fields.includes('polygon'));

/** The polygon named by each event of a run, read from the lines, usually without parsing them. */
export class Mentions {
  /** For each step, the index of the polygon in the scene; -1 for none. */
  private readonly places: Int32Array;
  private readonly byId: ReadonlyMap<string, number>;
  private seen = 0;

  constructor(private readonly trace: Trace) {
    const { header, timeline } = trace;
    this.places = new Int32Array(timeline.length + 1).fill(-1);
    this.byId = new Map(header.scene.polygons.map(({ id }, i) => [id, i]));
  }

  at(step: number): number {
    return this.places[step] ?? -1;
  }

  /** Continues for about this time. Returns whether all steps were read. */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    do this.readSome();
    while (!this.complete && performance.now() < end);
    return this.complete;
  }

  private get complete(): boolean {
    return this.seen >= this.places.length - 1;
  }

  private readSome(): void {
    const { names } = this.trace.timeline;
    const stop = Math.min(this.seen + atOnce, this.places.length - 1);
    for (; this.seen < stop; this.seen++) {
      if (mayName[names[this.seen] ?? -1] === true) this.look(this.seen + 1);
    }
  }

  private look(step: number): void {
    this.places[step] = this.byId.get(this.idIn(this.trace.timeline.line(step))) ?? -1;
  }

  private idIn(line: string): string {
    if (line.includes('\\')) return (JSON.parse(line) as { polygon?: string }).polygon ?? '';
    const at = line.indexOf(key);
    return at < 0 ? '' : line.slice(at + key.length, line.indexOf('"', at + key.length));
  }
}
