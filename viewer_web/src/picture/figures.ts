import { curveFigureOf } from '../curves/figure.js';
import type { Method } from '../trace/events.js';
import type { View } from '../view.js';
import { figureOf } from './figure.js';

const figures: Readonly<Record<Method, (view: View) => string>> = {
  warnock: figureOf,
  zbuffer: figureOf,
  'floating-horizon': curveFigureOf,
};

/** The picture of a step, of polygons or of curves, as an SVG document of its own. */
export const figureOfStep = (view: View): string => figures[view.header.method](view);
