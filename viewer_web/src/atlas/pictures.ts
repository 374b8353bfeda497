import { usual } from '../run/options.js';
import type { Options } from '../run/options.js';
import { Tracer } from '../run/tracer.js';
import type { Traced } from '../run/tracer.js';
import type { Entry } from './entries.js';
import { thumbnailOf } from './thumbnail.js';
import type { Thumbnail } from './thumbnail.js';

/** A longer run shows its picture after this number of events. */
const mostEvents = 20_000;

/** The final pictures of the atlas's runs, made one at a time. */
export class Pictures {
  private readonly tracer: Tracer;
  private tell: (trace: Traced['trace']) => void = () => undefined;

  constructor(library: Blob) {
    this.tracer = new Tracer(
      library,
      ({ trace }) => this.tell(trace),
      () => this.tell(null),
    );
  }

  /** Null if there is no run, or the library does not make it. */
  async of({ scene, fails, shows }: Entry): Promise<Thumbnail | null> {
    if (scene === undefined || fails === undefined) return null;
    const options: Options = { ...usual, ...fails, detail: 'windows' };
    const traced = new Promise<Traced['trace']>((tell) => (this.tell = tell));
    this.tracer.run(JSON.stringify(scene), options, mostEvents);
    const trace = await traced;
    return trace && thumbnailOf(trace, shows?.pixel ?? null);
  }
}
