import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import type { Scene } from '../trace/header.js';
import { beyond } from './beyond.js';
import type { Frame } from './frame.js';
import { marksOf } from './marks.js';
import { shapesOf } from './shapes.js';
import type { Shape } from './shapes.js';
import { gridShapes, notesOf, outlineShapes } from './still.js';
import type { Label } from './still.js';

/** The drawing over the pixels of a picture, from bottom to top, for the page and for figures. */
export interface Drawing {
  readonly shapes: readonly Shape[];
  readonly labels: readonly Label[];
}

/** The scene, which does not change from step to step; `under` lies under the polygons' outlines. */
export const sceneDrawing = (
  scene: Scene,
  frame: Frame,
  under: readonly Shape[] = [],
): readonly Shape[] => [...gridShapes(frame), ...under, ...outlineShapes(scene)];

/** The marks of the step; `over` lies under them. */
export function stepDrawing(view: View, frame: Frame, over: readonly Shape[] = []): Drawing {
  const marks = marksOf(view, frame.sight);
  const outside = beyond(marks, frame, numbersOf(view));
  return {
    shapes: [...over, ...marks.flatMap((mark) => shapesOf(mark, frame.scale)), ...outside.shapes],
    labels: [...notesOf(marks, frame), ...outside.labels],
  };
}
