import { horizonValues } from '../floating-horizon/canonical.js';
import type { Line } from './lines.js';
import { regionValues } from '../weiler-atherton/canonical.js';
import { hasThreeLists } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { toColor } from './grid.js';
import type { Screen } from './screen.js';
import type { State } from './state.js';
import type { Joined, Warnock } from '../warnock/state.js';
import type { ZBuffer } from '../zbuffer/state.js';

/**
 * The state in the one form in which readers of a trace are compared, key by key in this order. The lines are those that a
 * run of curves has drawn.
 */
export function canonical(
  state: State,
  { method, detail }: Header,
  lines: readonly Line[],
): unknown {
  const { step, calls, warnock, zbuffer, horizon, regions } = state.values;
  const begun = { step, calls: calls.map(({ of, at }) => ({ of, at })) };
  const { columns } = state;
  if (horizon !== null && columns !== null) {
    return { ...begun, ...horizonValues(horizon, columns, lines) };
  }
  return {
    ...begun,
    picture: pictureRows(state.screen),
    warnock: warnock && {
      ...warnockValues(warnock),
      ...(hasThreeLists(method) ? otherLists(warnock) : {}),
    },
    zbuffer: zbuffer && { ...zbufferValues(zbuffer), z: depthRows(state.screen, detail) },
    ...(regions && { weilerAtherton: regionValues(regions) }),
  };
}

function pictureRows({ picture }: Screen): readonly string[] {
  return Array.from({ length: picture.height }, (_, j) =>
    Array.from(picture.row(j) as ArrayLike<number>, toColor).join(''),
  );
}

function depthRows({ z }: Screen, detail: Header['detail']): unknown {
  if (z === null || detail === 'windows') return null;
  return Array.from({ length: z.height }, (_, j) => Array.from(z.row(j)));
}

function warnockValues(warnock: Warnock): object {
  const { stack, window, apl, clip, last } = warnock;
  const { corners, k, count, hasSurround, color, insider } = last;
  return {
    stack: stack.map((each) => ({ window: each.window, apl: each.apl.entries })),
    window,
    apl: apl?.entries ?? null,
    corners: corners && { lb: corners.lb, lt: corners.lt, rb: corners.rb, rt: corners.rt },
    k,
    count,
    hasSurround,
    color,
    insider,
    clip: clip && { vertices: clip.vertices, next: clip.next },
  };
}

function otherLists({ joined: { surrounding, outside } }: Warnock): object {
  const written = (list: Joined): unknown => list.map(({ polygon, level }) => [polygon, level]);
  return { surrounding: written(surrounding), outside: written(outside) };
}

function zbufferValues({ polygon, edges, ael, last }: ZBuffer): object {
  const { y, row, nextS, nextAel } = last;
  return {
    polygon,
    S: edges,
    ael: ael.map(({ edge, x, z, until, dx, dz }) => ({ edge, x, z, until, dx, dz })),
    y,
    row,
    nextS,
    nextAel,
  };
}
