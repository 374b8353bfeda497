import { expect, it } from 'vitest';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { ownStep } from './own-step.js';

const clear: Event = { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' };
const polygon: Event = { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' };
const wrong: Event = {
  e: 'disagree',
  at: 'Z2',
  of: 'rows',
  taken: [0, 1],
  exact: [0, 2],
  cause: 'rounded',
};

it.each([
  [0, 0],
  [1, 1], // clear
  [2, 3], // polygon, in the checked run after a verdict
  [3, 5], // polygon
])('step %i of a run is step %i of the same one, checked', async (step, checked) => {
  const header = headerOf('zbuffer');
  const plain = await traceOf(textWith(header, [clear, polygon, polygon]));
  const told = await traceOf(textWith(header, [clear, wrong, polygon, wrong, polygon]));
  expect(ownStep(plain.timeline, step, told.timeline)).toBe(checked);
  expect(ownStep(told.timeline, checked, plain.timeline)).toBe(step);
  expect(ownStep(told.timeline, 5, (await traceOf(textWith(header, [clear]))).timeline)).toBe(1);
});
