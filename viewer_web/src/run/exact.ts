import type { Exact } from '../picture/layers.js';
import { referenceOf } from '../trace/editions.js';
import type { Method } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import type { Options } from './options.js';
import { sceneText } from './sketch.js';
import { Tracer } from './tracer.js';
import type { Traced } from './tracer.js';

/** The run with a short trace that paints what a method should. */
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

/** The exact picture of the scene that was last asked for, by the library that the page brings along. */
export class ExactPicture {
  private readonly tracer: Tracer | null;
  private asked: Asked | null = null;
  /** The run that paints it: another trace may be of the same scene, too. */
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

  /** What is known of the picture that a method should paint; what is not is asked for and told as a change. */
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

  /** What can be said without asking: a scene has a picture until it was refused. */
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
