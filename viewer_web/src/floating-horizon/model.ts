import type { Columns } from '../replay/columns.js';
import type { Line } from '../replay/lines.js';
import { ValueInHand, defineModel } from '../replay/model.js';
import { effects, emptyFloatingHorizon } from './state.js';
import type { FloatingHorizon } from './state.js';

function values(
  { curve, place, edges }: FloatingHorizon,
  columns: Columns | null,
  lines: readonly Line[],
): object {
  const { upper = null, lower = null } = columns?.horizons ?? {};
  return {
    lines: lines.map((line) => [line.curve, line.from, line.to]),
    curve,
    segment: place.segment,
    previous: place.previous,
    current: place.current,
    leftEdge: edges.left,
    rightEdge: edges.right,
    upper: Array.from(upper?.row(0) ?? []),
    lower: Array.from(lower?.row(0) ?? []),
  };
}

defineModel(['floating-horizon'], {
  begin: () =>
    new ValueInHand('floatingHorizon', emptyFloatingHorizon, (event, now, { columns }) =>
      columns === null ? now : effects.after(event, now, columns),
    ),
  uses: effects.uses,
  compared: ({ held: { floatingHorizon = emptyFloatingHorizon }, columns, lines }) =>
    values(floatingHorizon, columns, lines),
});
