import { common, details, tables } from '../trace/events.js';
import type { Detail, Event, EventName, Procedure } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import { Screen } from './screen.js';
import type { SavedScreen } from './screen.js';
import { addDepth, afterWarnock, emptyWarnock } from './warnock.js';
import type { Warnock } from './warnock.js';
import { afterZBuffer, emptyZBuffer } from './zbuffer.js';
import type { ZBuffer } from './zbuffer.js';

/** A procedure that runs, and the label that it is at. */
export interface Frame {
  readonly of: Procedure | 'Warnock' | 'ZBuffer';
  readonly at: string | null;
}

/** What a step leaves behind, the cells of picture and Z-buffer apart. */
export interface Values {
  readonly step: number;
  readonly calls: readonly Frame[];
  readonly warnock: Warnock | null;
  readonly zbuffer: ZBuffer | null;
}

export interface Keyframe {
  readonly values: Values;
  readonly screen: SavedScreen;
}

/** The procedure whose frame an event closes, being its result. */
export const closes: Partial<Record<EventName, Procedure>> = {
  summary: 'ProcessWindow',
  color: 'PointColor',
  surround: 'SurroundTest',
  clip_result: 'PolygonClip',
  draw: 'FillPolygon',
  span: 'ShowLine',
};

/** Below the level of its call a result closes nothing. */
export function isTraced(procedure: Procedure, detail: Detail): boolean {
  const from = procedure === 'SurroundTest' ? 'signs' : common.call.from;
  return details.indexOf(detail) >= details.indexOf(from);
}

/** Everything at a step. Its values are immutable, so that a keyframe shares what does not change. */
export class State {
  values: Values;
  readonly screen: Screen;

  constructor(private readonly header: Header) {
    const warnock = header.method === 'warnock';
    this.screen = new Screen(header.scene, header.detail !== 'windows');
    this.values = {
      step: 0,
      calls: [{ of: warnock ? 'Warnock' : 'ZBuffer', at: null }],
      warnock: warnock ? emptyWarnock : null,
      zbuffer: warnock ? null : emptyZBuffer,
    };
  }

  /** The next step; an event that cannot happen here is refused. */
  apply(event: Event): void {
    const { step, warnock, zbuffer } = this.values;
    if ('polygon' in event) this.screen.polygon(event.polygon);
    this.values = {
      step: step + 1,
      calls: this.callsAfter(event),
      warnock: warnock && { ...warnock, ...this.inWarnock(event, warnock) },
      zbuffer: zbuffer && { ...zbuffer, ...this.inZBuffer(event, zbuffer) },
    };
  }

  save(): Keyframe {
    return { values: this.values, screen: this.screen.save() };
  }

  load({ values, screen }: Keyframe): void {
    this.values = values;
    this.screen.load(screen);
  }

  private callsAfter(event: Event): readonly Frame[] {
    const calls = [...this.values.calls];
    const closed = closes[event.e];
    if (closed !== undefined && isTraced(closed, this.header.detail)) {
      const top = calls.pop();
      if (top?.of !== closed) throw new Refusal('e', 'resultOf', closed, top?.of ?? '');
    }
    const top = calls.pop();
    if (top !== undefined) calls.push({ of: top.of, at: event.at });
    if (event.e === 'call') calls.push({ of: event.of, at: null });
    return calls;
  }

  private inWarnock(event: Event, now: Warnock): Partial<Warnock> {
    if (event.e === 'depth') return event.at === 'PW5' ? addDepth(event.z, now) : {};
    return isOf(event, tables.warnock) ? afterWarnock(event, now, this.screen) : {};
  }

  private inZBuffer(event: Event, now: ZBuffer): Partial<ZBuffer> {
    return isOf(event, tables.zbuffer) ? afterZBuffer(event, now, this.screen) : {};
  }
}

function isOf<T extends object>(event: Event, table: T): event is Event<keyof T & EventName> {
  return Object.hasOwn(table, event.e);
}
