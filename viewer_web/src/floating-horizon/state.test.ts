import { describe, expect, it } from 'vitest';
import { headerOf, keptOf, textOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';

const header = headerOf('floating-horizon');
const curve: Event = { e: 'curve', at: 'FH2', curve: 0 };
const looked = (at: 'FH4' | 'FH5', x: number, flag: 1 | 0): Event => ({
  e: 'visibility',
  at,
  segment: [0, 4],
  x,
  flag,
});
const called = (at: 'FH4' | 'FH5'): Event => ({ e: 'call', at, of: 'Visibility' });

describe('the state of the floating horizon', () => {
  it('has the last two columns with their flags, and forgets them with the next curve', async () => {
    const events = [
      curve,
      ...[called('FH4'), looked('FH4', 0, 1)],
      ...[called('FH5'), looked('FH5', 1, 1)],
      ...[called('FH5'), looked('FH5', 2, 0)],
      { ...curve, curve: 1 } satisfies Event,
    ];
    const { timeline } = await traceOf(textWith(header, events));
    const placeAt = (step: number): unknown => timeline.seek(step).values.floatingHorizon?.place;
    expect(placeAt(3)).toEqual({ segment: [0, 4], previous: [0, 1], current: null });
    expect(placeAt(5)).toEqual({ segment: [0, 4], previous: [0, 1], current: [1, 1] });
    expect(placeAt(7)).toEqual({ segment: [0, 4], previous: [1, 1], current: [2, 0] });
    expect(placeAt(8)).toEqual({ segment: null, previous: null, current: null });
  });

  it('keeps the horizons that a curve is compared with', async () => {
    const { timeline, header: of } = await traceOf(textOf('hills.floating-horizon.signs.jsonl'));
    const steps = Array.from({ length: timeline.length }, (_, i) => i + 1);
    const isRaised = (step: number): boolean => timeline.event(step)?.e === 'raise';
    const [raise = 0] = steps.filter(
      (step) => isRaised(step) && timeline.seek(step).values.floatingHorizon?.curve === 2,
    );
    const event = timeline.event(raise);
    if (event?.e !== 'raise') throw new Error('nothing was raised');
    const over = (heights: 'horizons' | 'before'): unknown =>
      timeline.valuesAt(raise).floatingHorizon?.[heights].upper[event.x - of.scene.area.x];
    expect(over('horizons')).toBe(event.y);
    expect(over('before')).not.toBe(event.y);
  });

  it.each([
    ['no curve of the scene', { ...curve, curve: 2 }],
    ['a column outside the area', { e: 'raise', at: 'H2', x: 8, y: 1 }],
    [
      'no segment of the curve',
      {
        e: 'draw_line',
        at: 'FH6',
        segment: [0, 7],
        from: [0, 2],
        fromColumns: [0, 0],
        to: [1, 2],
        toColumns: [1, 1],
      },
    ],
  ] as const)('refuses what cannot happen: %s', async (reason, event) => {
    const text = textWith(header, [curve, event]);
    expect((await keptOf(text)).shortened).toMatchObject({ why: 'wrong', line: 3, reason });
  });

  it('has the samples of the scene, from left to right', async () => {
    const scene = {
      format: 'vidno-surface/1',
      window: { x: 0, y: 0, width: 8, height: 8 },
      curves: [
        [
          [0, 1],
          [0, 2],
        ],
      ],
    };
    await expect(traceOf(textWith({ ...header, scene }, []))).rejects.toMatchObject({
      path: '/scene/curves/0/1/0',
      reason: 'not right of the sample before',
    });
  });
});
