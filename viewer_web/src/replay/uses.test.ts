import { describe, expect, it } from 'vitest';
import { eventNames, methods } from '../trace/events.js';
import { modelOf } from './model.js';
import { Uses } from './uses.js';

/** Whether a set of fields has exactly one. */
const isOne = (fields: number): boolean => fields !== 0 && (fields & (fields - 1)) === 0;

describe('the fields that events use', () => {
  it('have a bit each', () => {
    const uses = new Uses({ push: { sets: ['a'], changes: ['b'] }, pop: { reads: ['c'] } });
    const [push, pop] = [eventNames.indexOf('push'), eventNames.indexOf('pop')];
    expect(isOne(uses.set[push] ?? 0)).toBe(true);
    expect(isOne(uses.needed[pop] ?? 0)).toBe(true);
    // The event writes a and b and needs b and c; these are all its fields.
    expect((uses.written[push] ?? 0) & ~(uses.set[push] ?? 0)).toBe(uses.needed[push]);
    expect((uses.written[push] ?? 0) | (uses.needed[pop] ?? 0)).toBe(uses.everything);
  });

  it('are no more than the available bits', () => {
    const sets = Array.from({ length: 32 }, (_, i) => String(i));
    expect(() => new Uses({ push: { sets } })).toThrow('32 fields');
  });

  it.each(methods)('of %s belong to events that the method has', (method) => {
    const { uses } = modelOf({ method });
    const told = eventNames.flatMap((name) => uses.fieldsOf(name));
    expect(uses.everything).toBe(2 ** new Set(told).size - 1);
  });
});
