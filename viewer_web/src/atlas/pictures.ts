import { usual } from '../run/options.js';
import type { Options } from '../run/options.js';
import { Tracer } from '../run/tracer.js';
import type { Traced } from '../run/tracer.js';
import type { Entry } from './entries.js';
import { thumbnailOf } from './thumbnail.js';
import type { Thumbnail } from './thumbnail.js';

/** A run that goes on for longer shows what it shows before. */
const mostEvents = 20_000;

/** The pictures to which the runs of the atlas come, made one at a time. */
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

  /** Null where there is no run, or none that the library makes. */
  async of({ scene, fails, shows }: Entry): Promise<Thumbnail | null> {
    if (scene === undefined || fails === undefined) return null;
    const options: Options = { ...usual, ...fails, detail: 'windows' };
    const traced = new Promise<Traced['trace']>((tell) => (this.tell = tell));
    this.tracer.run(JSON.stringify(scene), options, mostEvents);
    const trace = await traced;
    return trace && thumbnailOf(trace, shows?.pixel ?? null);
  }
}
