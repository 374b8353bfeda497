import type { View } from '../algorithm/view.js';
import { atPoint, eventMarks, onRow, painted, rowBoxes } from '../picture/event-marks.js';
import type { Draws } from '../picture/event-marks.js';
import { point } from '../picture/mark.js';
import type { Mark } from '../picture/mark.js';

const draws: Draws = {
  paint: painted,
  behind: ({ point: at, behind }) => [point(behind ? 'no' : 'yes', at)],
  order: atPoint,
  row: ({ row, left, right, first, end }) => [
    onRow(row, left, right),
    ...rowBoxes('fresh', row, [[first, end]]),
  ],
};

/** The marks of the step's decision; the current pieces are drawn as regions. */
export const marks = (view: View): readonly Mark[] => eventMarks(draws, view);
