import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Trace } from '../replay/trace.js';
import { Pilot } from './pilot.js';

/** A run in which each call of `approach` moves 100 steps closer. */
function slowRun(): Trace {
  let at = 0;
  const approach = (step: number): number => {
    if (Math.abs(step - at) <= 100) at = step;
    else at += 100 * Math.sign(step - at);
    return Math.abs(step - at);
  };
  return { timeline: { length: 10_000, approach } } as unknown as Trace;
}

const host = {
  addController: vi.fn(),
  removeController: vi.fn(),
  requestUpdate: vi.fn(),
  updateComplete: Promise.resolve(true),
};

describe('a pilot', () => {
  beforeEach(() => {
    vi.useFakeTimers();
    host.requestUpdate.mockClear();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it('shows a near step at once', () => {
    const pilot = new Pilot(host, vi.fn());
    expect(pilot.follow(slowRun(), 50)).toBe(50);
    expect(pilot.isUnderWay).toBe(false);
  });

  it('shows the previous step until a far one is reached, and then requests a render', async () => {
    const pilot = new Pilot(host, vi.fn());
    const run = slowRun();
    pilot.follow(run, 50);
    expect(pilot.follow(run, 1000)).toBe(50);
    expect(pilot.follow(run, 1000)).toBe(50);
    expect(host.requestUpdate).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(1000);
    await pilot.arrival;
    expect(host.requestUpdate).toHaveBeenCalledOnce();
    expect(pilot.isUnderWay).toBe(false);
    expect(pilot.follow(run, 1000)).toBe(1000);
  });

  it('stays where it is when it is cancelled', async () => {
    const stay = vi.fn();
    const pilot = new Pilot(host, stay);
    const run = slowRun();
    pilot.follow(run, 50);
    pilot.follow(run, 1000);
    pilot.cancel();
    expect(stay).toHaveBeenCalledWith(50);
    await vi.advanceTimersByTimeAsync(1000);
    expect(host.requestUpdate).not.toHaveBeenCalled();
    expect(pilot.isUnderWay).toBe(false);
  });

  it('goes to the last requested step, and starts over in another run', async () => {
    const pilot = new Pilot(host, vi.fn());
    const run = slowRun();
    pilot.follow(run, 9000);
    pilot.follow(run, 500);
    await vi.advanceTimersByTimeAsync(1000);
    expect(pilot.follow(run, 500)).toBe(500);
    expect(pilot.follow(slowRun(), 9000)).toBe(0);
  });
});
