import { describe, expect, it } from 'vitest';
import { layersOf } from '../picture/layers.js';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import type { Event, Method } from '../trace/events.js';
import { toPixel } from './screen.js';

/** Milliseconds for which a page may block; a busy machine takes several times as long. */
const patience = 4000;

function timed<T>(act: () => T): readonly [T, number] {
  const start = performance.now();
  return [act(), performance.now() - start];
}

/** A header whose area has this side. */
function areaOf(side: number, method: Method): object {
  const header = headerOf(method) as { scene: object };
  const window = { x: 0, y: 0, width: side, height: side };
  return { ...header, scene: { ...header.scene, window } };
}

describe('a window with thousands of polygons', async () => {
  const count = 20_000;
  const ids = Array.from({ length: count }, (_, i) => `P${i}`);
  const header = headerOf('warnock') as { scene: { polygons: readonly object[] } };
  const polygons = ids.map((id) => ({ ...header.scene.polygons[0], id }));
  const whole = { ...header, scene: { ...header.scene, polygons } };
  const root: Event = {
    e: 'push',
    at: 'W3',
    window: [0, 0, 8, 8],
    apl: ids.map((id) => [id, false]),
  };
  const pop: Event = { e: 'pop', at: 'W5', window: [0, 0, 8, 8] };
  // All but the first and the last leave the list; the last is marked halfway.
  const leaving = ids.slice(1, -1).map((polygon): Event => ({ e: 'discard', at: 'PW3', polygon }));
  const half = leaving.length / 2;
  const mark: Event = { e: 'mark', at: 'PW8', polygon: ids.at(-1) ?? '' };
  const events = [root, pop, ...leaving.slice(0, half), mark, ...leaving.slice(half)];
  const text = textWith(whole, events);
  const { timeline } = await traceOf(text);

  it('has the right list at each step', () => {
    const listAt = (step: number) => timeline.seek(step).values.warnock?.apl?.entries ?? [];
    const [entries, taken] = timed(() => listAt(events.length));
    expect(entries).toEqual([
      ['P0', false],
      [`P${count - 1}`, true],
    ]);
    expect(taken).toBeLessThan(patience);
    expect(listAt(2 + half)).toHaveLength(count - half);
    expect(listAt(2 + half).at(-1)).toEqual([`P${count - 1}`, false]);
    expect(listAt(3 + half).at(-1)).toEqual([`P${count - 1}`, true]);
    expect(listAt(2)).toHaveLength(count);
  });
});

describe('a long run', async () => {
  const length = 100_000;
  const fills = Array.from({ length }, (_, i): Event => {
    const rect = [i % 8, Math.floor(i / 8) % 8, 1, 1] as const;
    return { e: 'fill', at: 'W8', rect, color: `#${i.toString(16).padStart(6, '0')}` };
  });
  const { timeline } = await traceOf(textWith(headerOf('warnock', 'windows'), fills));

  it('gives the same states going back from its end as going forward', () => {
    const [wrong, taken] = timed(() =>
      Array.from({ length: 200 }, (_, i) => length - i).filter((step) => {
        const pixel = timeline.seek(step).screen.picture.at((step - 1) % 8, ((step - 1) >> 3) % 8);
        return pixel !== toPixel(`#${(step - 1).toString(16).padStart(6, '0')}`);
      }),
    );
    expect(wrong).toEqual([]);
    expect(taken).toBeLessThan(patience);
  });
});

describe('a large area', () => {
  const side = 16384;

  it('is divided into no more windows than the eye can distinguish, and these are found at once', async () => {
    const push = (x: number, y: number, size: number): Event => ({
      ...{ e: 'push', at: size === side ? 'W3' : 'W13', window: [x, y, size, size] },
      ...(size === side && { apl: [] }),
    });
    const pop: Event = { e: 'pop', at: 'W5', window: [0, 0, side, side] };
    const parts = (size: number): readonly Event[] =>
      Array.from({ length: (side / size) ** 2 }, (_, i) =>
        push((i % (side / size)) * size, Math.floor(i / (side / size)) * size, size),
      );
    const sizes = [8192, 4096, 2048, 1024, 512, 256, 128, 64];
    const events = [push(0, 0, side), pop, ...sizes.flatMap(parts)];
    const { timeline } = await traceOf(textWith(areaOf(side, 'warnock'), events));
    const { screen } = timeline.seek(events.length);
    const [found, taken] = timed(() => screen.windows({ shown: [0, 0, side, side], least: 100 }));
    // Windows of 128 pixels are the smallest that are not less than 100.
    expect(found).toHaveLength(128 * 128);
    expect(taken).toBeLessThan(patience);
  });

  const line: readonly Event[] = [
    { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' },
    { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
    { e: 'call', at: 'Z14', of: 'ShowLine' },
    { e: 'span', at: 'Z14', row: 5, runs: [[2, 4]], depths: [0.25, 0.5] },
  ];

  it('is painted without depths, for which a browser has no memory', async () => {
    const { header, timeline } = await traceOf(textWith(areaOf(side, 'zbuffer'), line));
    const { screen } = timeline.seek(4);
    expect([1, 2, 3, 4].map((i) => screen.picture.at(i, 5) === toPixel('#112233'))).toEqual([
      false,
      true,
      true,
      false,
    ]);
    expect(screen.z).toBeNull();
    expect(layersOf(header, null)).toEqual(['picture']);
    expect(timeline.event(4)).toEqual(line[3]);
  });

  it('has depths up to 4096 pixels a side', async () => {
    const { header, timeline } = await traceOf(textWith(areaOf(4096, 'zbuffer'), line));
    expect(timeline.seek(4).screen.z?.at(3, 5)).toBe(0.5);
    expect(layersOf(header, null)).toEqual(['picture', 'depths']);
  });
});
