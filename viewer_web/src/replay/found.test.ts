import { describe, expect, it } from 'vitest';
import { samples } from '../testing/samples.js';
import { headerOf, pop, push, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { emptyWarnock } from '../warnock/state.js';
import { emptyZBuffer } from '../zbuffer/state.js';
import type { ZBuffer } from '../zbuffer/state.js';
import type { Trace } from './trace.js';
import type { Warnock } from './values.js';

const warnockAt = ({ timeline }: Trace, step: number): Warnock =>
  timeline.seek(step).values.warnock ?? emptyWarnock;

describe('a finding about a window or a polygon', () => {
  const corners: Event = { e: 'corners', at: 'PW1', z: '-inf' };
  const summary: Event = {
    e: 'summary',
    at: 'W6',
    count: 2,
    hasSurround: true,
    color: '#112233',
    insider: true,
  };
  const part: Event = { e: 'push', at: 'W13', window: [4, 0, 4, 4] };
  const popPart: Event = { ...pop, window: [4, 0, 4, 4] };

  it('does not apply to the next window, although the variables keep it', async () => {
    const call: Event = { e: 'call', at: 'W6', of: 'ProcessWindow' };
    const events = [push, pop, call, corners, summary, part, popPart, corners];
    const trace = await traceOf(textWith(headerOf('warnock'), events));
    const found = (step: number): unknown => {
      const { count, hasSurround, color, insider, corners: z } = warnockAt(trace, step);
      return [count, hasSurround, color, insider, z?.lb ?? null];
    };
    const nothing = [null, null, null, null, null];
    expect(found(2)).toEqual(nothing);
    expect(found(5)).toEqual([2, true, '#112233', true, '-inf']);
    expect(found(7)).toEqual(nothing);
    expect(found(8)).toEqual([0, false, null, false, '-inf']);
    expect(warnockAt(trace, 7).last).toMatchObject({ count: 2, color: '#112233' });
  });

  it('does not apply to the next polygon, although the variables keep it', async () => {
    const next: Event = { e: 'polygon', at: 'Z2', polygon: 'B', color: '#445566' };
    const sorted: Event = { e: 'ael_sort', at: 'Z12', edges: [], next: 4 };
    const left: Event = { e: 'leave', at: 'Z10', edges: [], next: 5 };
    const events = [...samples.polygon, ...samples.scanline, left, sorted, next];
    const trace = await traceOf(textWith(headerOf('zbuffer'), events));
    const at = (step: number): ZBuffer => trace.timeline.valuesAt(step).zbuffer ?? emptyZBuffer;
    const scanned = { y: 2.5, row: 2, nextS: 5, nextAel: 4 };
    expect(at(4)).toMatchObject({ ...scanned, last: scanned });
    const nothing = { y: null, row: null, nextS: null, nextAel: null };
    expect(at(5)).toMatchObject({ ...nothing, last: scanned });
  });
});
