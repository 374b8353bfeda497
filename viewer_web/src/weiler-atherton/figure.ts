import { figureFrame, figureOf } from '../picture/figure.js';
import type { View } from '../algorithm/view.js';
import { allLayers } from './layers.js';
import { regionShapes, visibleShapes } from './shapes.js';

/** The picture at a step with its regions, as an SVG document of its own; see `figureOf`. */
export const regionFigureOf = (view: View): string =>
  figureOf(view, {
    under: visibleShapes(view, allLayers),
    over: regionShapes(view, figureFrame(view), allLayers),
  });
