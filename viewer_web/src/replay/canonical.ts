import type { Header } from '../trace/header.js';
import { toColor } from './grid.js';
import type { Line } from './lines.js';
import { modelOf } from './model.js';
import type { Screen } from './screen.js';
import type { State } from './state.js';

/**
 * The state in the form in which readers of a trace are compared, with keys in this order. The lines are those that a run
 * of curves has drawn.
 */
export function canonical(state: State, header: Header, lines: readonly Line[]): unknown {
  const { values, screen, columns } = state;
  const { step, calls } = values;
  const { method, detail } = header;
  const begun = { step, calls: calls.map(({ of, at }) => ({ of, at })) };
  const own = modelOf(header).compared({ held: values, screen, columns, method, detail, lines });
  return { ...begun, ...own };
}

/** The picture, row by row. */
export function pictureRows({ picture }: Screen): readonly string[] {
  return Array.from({ length: picture.height }, (_, j) =>
    Array.from(picture.row(j) as ArrayLike<number>, toColor).join(''),
  );
}
