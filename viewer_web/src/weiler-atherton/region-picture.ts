import { customElement, property } from 'lit/decorators.js';
import { LayerSwitches } from '../elements/layer-switches.js';
import { texts } from '../i18n/index.js';
import type { RegionTexts } from '../language/texts.js';
import type { Frame } from '../picture/frame.js';
import type { Cells } from '../picture/paint.js';
import { regionsStyle } from '../picture/regions.style.js';
import type { Shape } from '../picture/shapes.js';
import { PictureElement } from '../polygons/picture.js';
import type { RegionLayer } from './shapes.js';
import { allLayers, regionLayers, regionShapes, visibleShapes } from './shapes.js';

/** The picture so far, with the regions and the marks of the step over it. */
@customElement('vidno-region-picture')
export class RegionPictureElement extends PictureElement {
  static override styles = [...PictureElement.styles, regionsStyle];

  @property({ attribute: false }) shown: ReadonlySet<RegionLayer> = allLayers;

  protected override get cells(): Cells | null {
    return this.shown.has('pixels') ? super.cells : null;
  }

  protected override under(): readonly Shape[] {
    return visibleShapes(this.view, this.shown);
  }

  protected override over(frame: Frame): readonly Shape[] {
    return regionShapes(this.view, frame, this.shown);
  }
}

/** The layers of the picture of regions. */
@customElement('vidno-region-layers')
export class RegionLayersElement extends LayerSwitches<RegionLayer> {
  protected override readonly all = regionLayers;

  protected override get names(): RegionTexts {
    return texts[this.view.language].regions;
  }
}
