import type { Exact } from '../picture/layers.js';
import { referenceOf } from '../trace/editions.js';
import type { Method } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import type { Options } from './options.js';
import { sceneText } from './sketch.js';
import { Tracer } from './tracer.js';
import type { Traced } from './tracer.js';

/** The options of the run with the shortest trace that paints the right picture of a method. */
const exactly = (method: Method): Options => ({
  method: referenceOf(method),
  edition: 'corrected',
  kernel: 'filtered',
  detail: 'windows',
  check: false,
});

type Asked = Pick<Header, 'scene' | 'method'>;

interface Run {
  readonly scene: string;
  readonly options: Options;
}

const isSame = (one: Run, other: Run | null): boolean =>
  one.scene === other?.scene && one.options.method === other.options.method;

/** The exact picture of the last requested scene, made by the page's library. */
export class ExactPicture {
  private readonly tracer: Tracer | null;
  private asked: Asked | null = null;
  /** The run that paints it. Other traces may have the same scene. */
  private wanted: Run | null = null;
  private running: Run | null = null;
  private picture: Exact = null;

  constructor(
    library: Blob | null,
    private readonly changed: () => void,
  ) {
    const fail = (): void => this.take({ trace: null, messages: '' });
    this.tracer = library && new Tracer(library, (traced) => this.take(traced), fail);
  }

  /**
   * The right picture of a method, as far as it is known. An unknown one is requested, and its arrival is reported as a
   * change.
   */
  of(asked: Asked): Exact {
    if (this.tracer === null || this.isAsked(asked)) return this.picture;
    this.asked = asked;
    const run = { scene: sceneText(asked.scene), options: exactly(asked.method) };
    if (!isSame(run, this.wanted)) {
      this.wanted = run;
      this.picture = 'computing';
      if (this.running === null) this.run();
    }
    return this.picture;
  }

  /** The picture without a request. A scene is assumed to have one until the library refuses it. */
  unasked(asked: Asked): Exact {
    if (this.tracer === null || this.isAsked(asked)) return this.picture;
    return 'computing';
  }

  private isAsked({ scene, method }: Asked): boolean {
    return scene === this.asked?.scene && method === this.asked.method;
  }

  private run(): void {
    const { wanted } = this;
    this.running = wanted;
    if (wanted !== null) this.tracer?.run(wanted.scene, wanted.options);
  }

  private take({ trace }: Traced): void {
    const isWanted = this.running === this.wanted;
    this.running = null;
    if (!isWanted) {
      this.run();
      return;
    }
    const whole = trace?.shortened === null ? trace.timeline : null;
    this.picture = whole?.seek(whole.length).screen.picture ?? null;
    this.changed();
  }
}
