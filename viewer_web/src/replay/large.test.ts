import { describe, expect, it } from 'vitest';
import { layersOf } from '../picture/layers.js';
import { bareTimelineOf, headerOf, textWith, traceOf } from '../testing/traces.js';
import type { Event, Method } from '../trace/events.js';
import { Grid, toPixel } from './grid.js';
import { leaves } from './quadtree.js';

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
  const bare = await bareTimelineOf(text);

  it('has the right list at each step if the whole run is read at once', () => {
    const listAt = (step: number) => bare.seek(step).values.warnock?.apl?.entries ?? [];
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

  it('has the same lists where it is read', () => {
    expect(timeline.seek(events.length).values.warnock?.apl?.entries).toHaveLength(2);
    expect(timeline.seek(2 + half).values.warnock?.apl?.entries).toHaveLength(count - half);
  });
});

describe('a run without keyframes', async () => {
  const length = 100_000;
  const fills = Array.from({ length }, (_, i): Event => {
    const rect = [i % 8, Math.floor(i / 8) % 8, 1, 1] as const;
    return { e: 'fill', at: 'W8', rect, color: `#${i.toString(16).padStart(6, '0')}` };
  });
  const timeline = await bareTimelineOf(textWith(headerOf('warnock', 'windows'), fills));

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

  it('is divided into no more windows than the eye can distinguish, and these are found at once', () => {
    const levels = new Pixels(side, side, 14, (n) => new Uint8Array(n));
    let looks = 0;
    const at = levels.at.bind(levels);
    levels.at = (i, j) => {
      looks++;
      return at(i, j);
    };
    const area = { x: 0, y: 0, width: side, height: side };
    const sight = { shown: [0, 0, side, side], least: 100 } as const;
    const found = leaves(levels, [0, 0, side, side], area, sight);
    // Windows of 128 pixels are the smallest that are not less than 100.
    expect(found).toHaveLength(128 * 128);
    expect(looks).toBe(found.length);
  });

  const line: readonly Event[] = [
    { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' },
    { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
    { e: 'call', at: 'Z14', of: 'ShowLine' },
    { e: 'span', at: 'Z14', row: 5, runs: [[2, 4]], depths: [0.25, '1/3'] },
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
    expect(timeline.seek(4).screen.z?.at(3, 5)).toBe('1/3');
    expect(layersOf(header, null)).toEqual(['picture', 'depths']);
  });
});
