import type { Exact } from '../picture/layers.js';
import type { Scene } from '../trace/header.js';
import type { Options } from './options.js';
import { sceneText } from './sketch.js';
import { Tracer } from './tracer.js';
import type { Traced } from './tracer.js';

/** Every corrected method paints the same picture with it; this one has the shortest trace. */
const exactly: Options = {
  method: 'zbuffer',
  edition: 'corrected',
  kernel: 'filtered',
  detail: 'windows',
  check: false,
};

/** The exact picture of the scene that was last asked for, by the library that the page brings along. */
export class ExactPicture {
  private readonly tracer: Tracer | null;
  private scene: Scene | null = null;
  /** The same as text: another trace may be of it, too. */
  private wanted = '';
  /** The scene that is run now. */
  private running: string | null = null;
  private picture: Exact = null;

  constructor(
    library: Blob | null,
    private readonly changed: () => void,
  ) {
    const fail = (): void => this.take({ trace: null, messages: '' });
    this.tracer = library && new Tracer(library, (traced) => this.take(traced), fail);
  }

  /** What is known of a scene's picture; what is not is asked for and told as a change. */
  of(scene: Scene): Exact {
    if (this.tracer === null || scene === this.scene) return this.picture;
    this.scene = scene;
    const text = sceneText(scene);
    if (text !== this.wanted) {
      this.wanted = text;
      this.picture = 'computing';
      if (this.running === null) this.run();
    }
    return this.picture;
  }

  /** What can be said without asking: a scene has a picture until it was refused. */
  unasked(scene: Scene): Exact {
    if (this.tracer === null || scene === this.scene) return this.picture;
    return 'computing';
  }

  private run(): void {
    this.running = this.wanted;
    this.tracer?.run(this.wanted, exactly);
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
