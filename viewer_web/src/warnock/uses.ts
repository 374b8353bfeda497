import { Uses, nothing } from '../replay/uses.js';
import type { Use } from '../replay/uses.js';
import type { CommonEvents, WarnockEvents } from '../trace/events.js';

const ofWindow = ['corners', 'k', 'count', 'hasSurround', 'color', 'insider'];
/** Fields with copies of some values that outlive the window. */
const kept = ['last'];

/** Windows on the stack may share a list of active polygons. */
const list: Use = { changes: ['apl', 'stack'], needs: ['apl'] };
const joining: Use = { changes: ['apl', 'stack', 'joined'], needs: ['apl', 'joined'] };
const vertex: Use = { changes: ['clip'], needs: ['clip'] };
const painting: Use = { changes: ['picture'], needs: [] };

const table: Readonly<Record<keyof CommonEvents | keyof WarnockEvents, Use>> = {
  plane: nothing,
  call: nothing,
  depth: { changes: ['depths'] },
  fault: nothing,
  disagree: nothing,

  push: { changes: ['stack', 'root', 'division'], reads: ['apl'], needs: ['apl'] },
  skip: nothing,
  pop: {
    changes: ['stack', 'way'],
    sets: ['window', 'apl', 'nearest', 'covering', ...ofWindow],
    reads: ['window'],
    needs: ['stack'],
  },
  corners: { sets: [...ofWindow, 'covering', 'depths', 'last'] },
  box: nothing,
  discard: list,
  count: { sets: ['count', 'depths'], changes: kept },
  compare: nothing,
  nearer: {
    changes: ['corners', ...kept],
    sets: ['k'],
    reads: ['depths'],
    needs: ['corners', 'depths'],
  },
  uncover: { sets: ['hasSurround', 'covering'], changes: kept },
  surround: nothing,
  mark: list,
  cover: { sets: ['hasSurround', 'covering', 'color'], changes: kept },
  insider: { sets: ['insider'], changes: kept },
  summary: { sets: ['count', 'hasSurround', 'color', 'insider'], changes: kept },
  decide: nothing,
  fill: painting,
  nearest: { sets: ['nearest'] },
  color: { sets: ['color'], changes: kept },
  orient: nothing,
  clip_begin: { sets: ['clip'] },
  clip_side: vertex,
  clip_sign: nothing,
  clip_cross: vertex,
  clip_keep: vertex,
  clip_drop: nothing,
  clip_list: vertex,
  clip_result: { sets: ['clip'] },
  row: nothing,
  draw: painting,

  back_face: nothing,
  rejoin: joining,
  join: joining,
  relation: { sets: ['contained'] },
  trial: nothing,
  meets: { sets: ['contained'] },
  ray: { changes: ['contained'] },
  crossings: nothing,
  octants: { changes: ['contained'] },
  angle: nothing,
  hiding: { sets: ['hasSurround', 'covering'], changes: kept },
  split_vertex: nothing,
  edge_depth: nothing,
};

export const uses = new Uses(table);
