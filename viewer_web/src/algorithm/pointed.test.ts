import { describe, expect, it } from 'vitest';
import { textOf, traceOf } from '../testing/traces.js';
import { nextThing, sayThing, thingOf, thingsOf } from './pointed.js';
import { viewOf } from './view.js';
import type { View } from './view.js';

async function at(name: string, step: number, pointed: string | null = null): Promise<View> {
  const trace = await traceOf(textOf(name));
  return viewOf(trace, step, { language: 'en', pixel: null, pointed });
}

describe('the things that can be pointed at', () => {
  it('are at first only the polygons', async () => {
    const view = await at('small.warnock.signs.jsonl', 0);
    expect(thingsOf(view)).toEqual(view.header.scene.polygons.map(({ id }) => `polygon ${id}`));
  });

  it('are later those of the state, with windows from the top of the stack', async () => {
    const split = textOf('small.warnock.signs.jsonl')
      .split('\n')
      .findIndex((line) => line.includes('"case":"split"'));
    const view = await at('small.warnock.signs.jsonl', split + 4);
    const windows = (view.after.warnock?.stack ?? []).map(({ window }) => window.join(' '));
    const things = thingsOf(view);
    expect(windows.length).toBeGreaterThan(1);
    expect(things.filter((thing) => thing.startsWith('window'))).toEqual(
      windows.reverse().map((window) => `window ${window}`),
    );
    expect(things).toContain('corner lb');
  });

  it('are visited in both directions, with none between the last and the first', async () => {
    const view = await at('small.zbuffer.signs.jsonl', 60);
    const things = thingsOf(view);
    let thing: string | null = null;
    for (const expected of [...things, null, things[0] ?? null]) {
      thing = nextThing(thing, 1, view);
      expect(thing).toBe(expected);
    }
    expect(nextThing(null, -1, view)).toBe(things.at(-1));
  });

  it('are only those of the step', async () => {
    expect(thingOf('polygon nobody', await at('small.warnock.signs.jsonl', 0))).toBe(null);
    expect(thingOf('edge 0', await at('small.warnock.signs.jsonl', 10))).toBe(null);
    expect(sayThing(await at('small.warnock.signs.jsonl', 0, 'polygon nobody'))).toBe('');
  });

  it('have names', async () => {
    const view = await at('small.warnock.signs.jsonl', 0, 'polygon A');
    expect(sayThing(view)).toBe('Polygon A');
  });
});
