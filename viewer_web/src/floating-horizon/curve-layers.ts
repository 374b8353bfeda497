import { customElement } from 'lit/decorators.js';
import { allLayers, curveLayers, linesAlone } from './layers.js';
import type { Layer } from './layers.js';
import { texts } from '../i18n/index.js';
import type { CurveTexts } from '../language/curve-texts.js';
import { LayerSwitches } from '../elements/layer-switches.js';

/** The layers of the picture of curves. */
@customElement('vidno-curve-layers')
export class CurveLayersElement extends LayerSwitches<Layer> {
  protected override readonly all = curveLayers;
  protected override readonly key = 'L';

  protected override get names(): CurveTexts {
    return texts[this.view.language].curves;
  }

  /** Switches between the lines alone and everything. */
  next(): void {
    this.show(this.layers.size === 1 && this.layers.has('lines') ? allLayers : linesAlone);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-curve-layers': CurveLayersElement;
  }
}
