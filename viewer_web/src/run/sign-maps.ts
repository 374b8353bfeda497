import { mappedDecisionText } from '../exactness/mapped-decision.js';
import type { MappedDecision } from '../exactness/mapped-decision.js';
import { side } from '../exactness/places.js';
import { SignMap } from '../exactness/sign-map.js';
import { Maker } from './maker.js';

/** Computes the same decision at all its places under a kernel and in exact arithmetic, with the page's library. */
export class SignMaps {
  private readonly maker: Maker<'map'>;
  private tell: (map: SignMap | null) => void = () => undefined;

  constructor(library: Blob) {
    this.maker = new Maker(
      library,
      'map',
      ({ made }) => this.take(made),
      () => this.take(null),
    );
  }

  /** Null if the kernel has no map, or if another one was requested meanwhile. */
  of(decision: MappedDecision, kernel: string): Promise<SignMap | null> {
    this.tell(null);
    return new Promise((tell) => {
      this.tell = tell;
      this.maker.ask(`${JSON.stringify({ kernel, side })}\n${mappedDecisionText(decision)}`);
    });
  }

  private take(made: string | null): void {
    if (!this.maker.isBusy) this.tell(made === null ? null : new SignMap(made));
  }
}
