import { marginIn } from '../exactness/margin.js';
import type { Margin } from '../exactness/margin.js';
import type { Trace } from '../replay/trace.js';
import { Maker } from './maker.js';
import { sceneText } from './sketch.js';
import type { Spot } from './sketch.js';

/** Finds the region to which a vertex may be moved without changing a sign of a step, with the page's library. */
export class Margins {
  private readonly maker: Maker<'margin'>;
  private wanted = '';
  private found: { readonly request: string; readonly margin: Margin | null } | null = null;

  constructor(
    library: Blob,
    private readonly changed: () => void,
  ) {
    this.maker = new Maker(
      library,
      'margin',
      ({ made }) => this.take(made),
      () => this.take(null),
    );
  }

  /** Null while it is not known, and if the step has no such sign. Steps are those of level `signs`. */
  of({ header }: Trace, step: number, { polygon, vertex }: Spot): Margin | null {
    const { method, edition, kernel, detail, scene } = header;
    const id = scene.polygons[polygon]?.id;
    if (detail !== 'signs' || edition !== 'corrected' || id === undefined) return null;
    const asked = JSON.stringify({ method, edition, kernel, step, polygon: id, vertex });
    const request = `${asked}\n${sceneText(scene)}`;
    if (this.found?.request === request) return this.found.margin;
    if (this.wanted !== request) {
      this.wanted = request;
      this.maker.ask(request);
    }
    return null;
  }

  private take(made: string | null): void {
    if (this.maker.isBusy) return;
    this.found = { request: this.wanted, margin: made === null ? null : marginIn(made) };
    this.changed();
  }
}
