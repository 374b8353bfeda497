import type { View } from '../algorithm/view.js';
import { figureFrame, figureOf as polygonsFigure } from '../picture/figure.js';
import { allLayers } from './layers.js';
import { regionShapes, visibleShapes } from './shapes.js';

/** The picture at a step with its regions, as a separate SVG document; see `figureOf`. */
export const figureOf = (view: View): string =>
  polygonsFigure(view, {
    under: visibleShapes(view, allLayers),
    over: regionShapes(view, figureFrame(view), allLayers),
  });
