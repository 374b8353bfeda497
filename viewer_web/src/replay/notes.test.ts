import { describe, expect, it } from 'vitest';
import type { Language } from '../language/language.js';
import { headerOf, textWith, traceOf, pop, push } from '../testing/traces.js';
import type { Event } from '../trace/events.js';

/** Two polygons in a window: A is done, and B is being tested at its first corner. */
const events: readonly Event[] = [
  push,
  pop,
  { e: 'call', at: 'W6', of: 'ProcessWindow' },
  { e: 'corners', at: 'PW1', z: '-inf' },
  { e: 'box', at: 'PW3', polygon: 'A', box: [0, 0, 8, 8], outside: false },
  { e: 'count', at: 'PW4', polygon: 'A', count: 1 },
  { e: 'insider', at: 'PW10', polygon: 'A', inside: false },
  { e: 'box', at: 'PW3', polygon: 'B', box: [0, 0, 8, 8], outside: false },
  { e: 'count', at: 'PW4', polygon: 'B', count: 2 },
  { e: 'call', at: 'PW8', of: 'SurroundTest' },
  { e: 'orient', at: 'S2', polygon: 'B', edge: 3, point: [0, 0], value: -4, sign: -1 },
  { e: 'orient', at: 'S3', polygon: 'B', edge: 0, point: [0, 0], value: -2, sign: -1 },
  { e: 'surround', at: 'PW8', polygon: 'B', point: [0, 0], inside: true },
];

async function at(
  step: number,
  language: Language = 'en',
): Promise<Readonly<Record<string, string>>> {
  const trace = await traceOf(textWith(headerOf('warnock'), events));
  return Object.fromEntries(trace.timeline.notesAt(step, language));
}

describe('the notes beside a listing', () => {
  it('are the last notes of each line, in the procedure and in its callers', async () => {
    expect(await at(12)).toEqual({
      W5: '(0, 0) 8 × 8',
      PW1: 'z = −∞',
      PW3: 'false',
      PW4: '2',
      S2: '−4 < 0',
      S3: '−2 < 0',
    });
  });

  it('have the number format of the language', async () => {
    expect((await at(12, 'ru'))['W5']).toBe('(0; 0) 8 × 8');
  });

  it('of a later line end when its loop begins again', async () => {
    expect(await at(7)).toMatchObject({ PW4: '1', PW10: 'false' });
    expect(await at(8)).not.toHaveProperty('PW10');
    expect(await at(8)).not.toHaveProperty('PW4');
  });

  it('of a procedure end with it, and its result belongs to the caller', async () => {
    const values = await at(13);
    expect(values['PW8']).toBe('true');
    expect(Object.keys(values).filter((label) => label.startsWith('S'))).toEqual([]);
  });

  it('are none before the first step', async () => {
    expect(await at(0)).toEqual({});
  });
});

it('the reason of a fault is noted in the language of the page, unless another program wrote it', async () => {
  const note = async (reason: string, language: Language): Promise<string> => {
    const fault: Event = { e: 'fault', at: 'L6', reason };
    return (await traceOf(textWith(headerOf('zbuffer'), [fault]))).timeline.note(1, language);
  };
  expect(await note('division by zero', 'en')).toBe('division by zero');
  expect(await note('division by zero', 'ru')).toBe('деление на нуль');
  expect(await note('out of memory', 'ru')).toBe('out of memory');
});
