import { describe, expect, it } from 'vitest';
import { headerOf, textWith, traceOf, pop, push } from '../testing/traces.js';
import type { Event, Method } from '../trace/events.js';
import { mappedDecisionOf, mappedDecisionText } from './mapped-decision.js';
import type { MappedDecision } from './mapped-decision.js';

/** The decision of the last event, on the scene of two squares from (0, 0) to (8, 8), A and B, both at z = 1/2. */
async function asked(method: Method, ...events: readonly Event[]): Promise<MappedDecision | null> {
  const trace = await traceOf(textWith(headerOf(method), events));
  return mappedDecisionOf(trace, events.length);
}

const square = [
  [0, 0, 0.5],
  [8, 0, 0.5],
  [8, 8, 0.5],
  [0, 8, 0.5],
];
const corners: Event = { e: 'corners', at: 'PW1', z: '-inf' };
const depths = [1, 2, 3, 4].map((): Event => ({
  e: 'depth',
  at: 'PW5',
  polygon: 'A',
  point: [0, 0],
  z: 0.5,
}));
const nearer: Event = { e: 'nearer', at: 'PW6', polygon: 'A', corners: ['lb', 'lt'], k: 2 };
const compare = (corner: 'lb' | 'lt' | 'rb'): Event => ({
  e: 'compare',
  at: 'PW6',
  polygon: 'B',
  corner,
  z: 0.5,
  against: 0.5,
  nearer: false,
});

describe('a sign', () => {
  it('of an edge asks on which side of it the point is', async () => {
    const orient: Event = {
      e: 'orient',
      at: 'S2',
      polygon: 'A',
      edge: 3,
      point: [4.5, 2],
      value: 36,
      sign: 1,
    };
    // Edge 3 goes from the last vertex, (0, 8), to the first. The differences are relative to its start.
    const decision = await asked('warnock', orient);
    expect(decision?.at).toEqual([4.5, 2]);
    expect(decision?.asked).toEqual({ orientation: { q: [0, 8], r: [0, 0], pivot: 'q' } });
  });

  it('of a window’s side asks on which side of that a vertex is', async () => {
    const side: Event = { e: 'clip_side', at: 'PL2', side: 2, from: [4, 4], to: [4, 8] };
    const sign: Event = { e: 'clip_sign', at: 'PL4', vertex: [8, 0, 0.5], value: 16, sign: 1 };
    const begin: Event = { e: 'clip_begin', at: 'PL1', polygon: 'A', window: [4, 4, 4, 4] };
    const decision = await asked('warnock', push, pop, begin, side, sign);
    expect(decision?.at).toEqual([8, 0]);
    expect(decision?.asked).toEqual({ orientation: { q: [4, 4], r: [4, 8], pivot: 'r' } });
  });
});

describe('a comparison of depths', () => {
  it('at a corner is with the last polygon that was nearer there', async () => {
    const before = [push, pop, corners, ...depths, nearer];
    const decision = await asked('warnock', ...before, compare('lt'));
    expect(decision?.at).toEqual([0, 8]);
    expect(decision?.asked).toEqual({ depth: { polygons: [square, square] } });
    expect(await asked('warnock', ...before, compare('rb'))).toBeNull(); // there is nothing yet
  });

  it('in the next window does not use the previous one', async () => {
    const events = [push, pop, corners, ...depths, nearer, push, pop, corners, compare('lb')];
    expect(await asked('warnock', ...events)).toBeNull();
  });

  it('at a pixel is with the polygon that it shows', async () => {
    const polygon = (id: string): Event => ({
      e: 'polygon',
      at: 'Z2',
      polygon: id,
      color: '#112233',
    });
    const pixel = (x: number, shown: boolean): Event => ({
      e: 'pixel',
      at: 'L6',
      x,
      y: 2,
      z: 0.5,
      stored: 0.5,
      shown,
    });
    const decision = await asked(
      'zbuffer',
      polygon('A'),
      pixel(1, true),
      polygon('B'),
      pixel(1, false),
    );
    expect(decision?.at).toEqual([1.5, 2.5]);
    expect(await asked('zbuffer', polygon('A'), pixel(2, true), pixel(1, true))).toBeNull();
  });
});

it('a verdict asks what the step before it asked', async () => {
  const call: Event = { e: 'call', at: 'PC2', of: 'SurroundTest' };
  const surround: Event = {
    e: 'surround',
    at: 'PC2',
    polygon: 'B',
    point: [0.5, 3.5],
    inside: true,
  };
  const wrong: Event = {
    e: 'disagree',
    at: 'PC2',
    of: 'orientation',
    taken: 0,
    exact: 1,
    cause: 'rounded',
  };
  const decision = await asked('warnock', call, surround, wrong);
  expect(decision?.asked).toEqual({
    surround: { polygon: square.map(([x, y]) => [x, y]) },
  });
  const file = decision && (JSON.parse(mappedDecisionText(decision)) as object);
  expect(file).toMatchObject({ format: 'vidno-question/1', step: 2 ** -51 }); // 3.5 = 1.75 * 2^1
});
