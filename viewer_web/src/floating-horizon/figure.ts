import type { View } from '../algorithm/view.js';
import { figureDocument, figureFrame, pathOf } from '../picture/figure.js';
import { allLayers } from './layers.js';
import { curveShapes } from './shapes.js';

/** The picture of curves at a step with all layers, as a separate SVG document; see `figureOf`. */
export function figureOf(view: View): string {
  const frame = figureFrame(view);
  const shapes = curveShapes({ ...view, pointed: null, asked: [] }, frame, allLayers);
  return figureDocument(view, frame, shapes.map((shape) => pathOf(shape, frame.scale)).join(''));
}
