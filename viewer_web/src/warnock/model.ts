import { pictureRows } from '../replay/canonical.js';
import { defineModel } from '../replay/model.js';
import type { Hand, Held, Paper } from '../replay/model.js';
import { hasThreeLists, hasWindows, methods } from '../trace/events.js';
import type { Event } from '../trace/events.js';
import { ListInHand } from './list-in-hand.js';
import { effects, emptyWarnock } from './state.js';
import type { Joined, Warnock } from './state.js';

/** Warnock's algorithm, with the list of the current window handled separately. */
class WarnockInHand implements Hand {
  private warnock = emptyWarnock;
  private readonly list = new ListInHand();

  get held(): Held {
    this.warnock = this.list.settled(this.warnock);
    return { warnock: this.warnock };
  }

  take(event: Event, { screen }: Paper): void {
    if (this.list.take(event, this.warnock)) return;
    this.warnock = effects.after(event, this.list.before(event, this.warnock), screen);
  }

  load({ warnock = emptyWarnock }: Held): void {
    this.list.forget();
    this.warnock = warnock;
  }
}

function values({ stack, window, apl, clip, last }: Warnock): object {
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

defineModel(methods.filter(hasWindows), {
  begin: () => new WarnockInHand(),
  uses: effects.uses,
  compared: ({ held: { warnock = emptyWarnock }, method, screen }) => ({
    picture: pictureRows(screen),
    warnock: { ...values(warnock), ...(hasThreeLists(method) ? otherLists(warnock) : {}) },
    zbuffer: null,
  }),
});
