import { curveFigureOf } from '../floating-horizon/figure.js';
import { regionFigureOf } from '../weiler-atherton/figure.js';
import { methodKindOf } from '../trace/method-kind.js';
import type { MethodKind } from '../trace/method-kind.js';
import type { View } from '../algorithm/view.js';
import { figureOf } from './figure.js';

const figures: Readonly<Record<MethodKind, (view: View) => string>> = {
  windows: figureOf,
  scanlines: figureOf,
  curves: curveFigureOf,
  regions: regionFigureOf,
};

/** The picture of a step, of polygons or of curves, as an SVG document of its own. */
export const figureOfStep = (view: View): string => figures[methodKindOf(view.header.method)](view);
