import { customElement } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import type { RegionTexts } from '../language/region-texts.js';
import { regionLayers } from './layers.js';
import type { RegionLayer } from './layers.js';
import { LayerSwitches } from '../elements/layer-switches.js';

/** The layers of the picture of regions. */
@customElement('vidno-region-layers')
export class RegionLayersElement extends LayerSwitches<RegionLayer> {
  protected override readonly all = regionLayers;

  protected override get names(): RegionTexts {
    return texts[this.view.language].regions;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-region-layers': RegionLayersElement;
  }
}
