import type { Bilingual } from '../language/language.js';
import type { Pixel } from '../picture/pixel.js';
import type { Trace } from '../replay/trace.js';
import type { Options } from '../run/options.js';
import { Tracer } from '../run/tracer.js';
import type { Edition } from '../trace/editions.js';
import witnesses from '../trace/witnesses.json' with { type: 'json' };

interface Entry {
  readonly kernel: string;
  readonly title: Bilingual<string>;
  readonly scene: unknown;
}
const entries: Readonly<Record<string, Entry>> = witnesses;

/** The place in the runs of the witness. */
export interface WitnessPlace {
  readonly step: number;
  readonly pixel: Pixel | null;
}
const beginning: WitnessPlace = { step: 0, pixel: null };

/**
 * The smallest scene that shows a broken line: its right run and the broken one. They are shown instead of the open runs,
 * which are kept.
 */
export class Witness {
  right: Trace | null = null;
  broken: Trace | null = null;
  place = beginning;
  /** The deviation that it demonstrates; null while it is closed. */
  edition: Edition | null = null;
  private readonly tracers: readonly Tracer[];

  constructor(
    library: Blob | null,
    private readonly changed: () => void,
  ) {
    const tracer = (side: 'right' | 'broken'): readonly Tracer[] => {
      if (library === null) return [];
      const take = (trace: Trace | null): void => {
        if (trace === null) this.close();
        else if (this.edition !== null) this[side] = trace;
        this.changed();
      };
      return [
        new Tracer(
          library,
          ({ trace }) => take(trace),
          () => take(null),
        ),
      ];
    };
    this.tracers = [...tracer('right'), ...tracer('broken')];
  }

  /** Whether both runs are ready. */
  get isOpen(): boolean {
    return this.right !== null && this.broken !== null;
  }

  /** Its value in an address. */
  get word(): number | null {
    return this.edition === null ? null : this.place.step;
  }

  get title(): Entry['title'] | null {
    return entries[this.edition ?? '']?.title ?? null;
  }

  /** Runs it by a method that has the deviation. */
  open({ edition, method }: Pick<Options, 'edition' | 'method'>, step = 0): void {
    const entry = entries[edition];
    this.close();
    if (entry === undefined || this.tracers.length === 0) return;
    this.edition = edition;
    this.place = { step, pixel: null };
    const options: Options = {
      method,
      edition: 'corrected',
      kernel: entry.kernel,
      detail: 'signs',
      check: false,
    };
    const scene = JSON.stringify(entry.scene);
    this.tracers[0]?.run(scene, options);
    this.tracers[1]?.run(scene, { ...options, edition });
    this.changed();
  }

  close(): void {
    for (const tracer of this.tracers) tracer.forget();
    this.edition = null;
    this.right = null;
    this.broken = null;
    this.place = beginning;
  }

  move(change: Partial<WitnessPlace>): void {
    this.place = { ...this.place, ...change };
    this.changed();
  }
}
