import { describe, expect, it } from 'vitest';
import type { Owners } from '../algorithm/owners.js';
import { texts } from '../i18n/index.js';
import type { Screen } from '../replay/screen.js';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { factsAt } from './pixel-facts.js';

/** The background is #ffffff, A is #112233, B #445566. */
const squares = headerOf('warnock') as { scene: { polygons: readonly object[] } };

const only = (id: string): Owners => ({ polygons: [id], background: false });

async function screenAfter(header: object, ...events: readonly Event[]): Promise<Screen> {
  const { timeline } = await traceOf(textWith(header, events));
  return timeline.seek(events.length).screen;
}

/** A rectangle from the top left corner of the area. */
const fill = (width: number, height: number, color: string): Event => ({
  e: 'fill',
  at: 'W8',
  rect: [0, 0, width, height],
  color,
});

describe('the spoken text of a pixel', () => {
  const buffered: readonly Event[] = [
    { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' },
    { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
    { e: 'call', at: 'Z14', of: 'ShowLine' },
    { e: 'span', at: 'Z14', row: 1, runs: [[2, 5]], depths: [0, 0.25, 0.5] },
  ];
  const said = async (
    [x, y]: readonly [number, number],
    owners: Owners | null,
    steps: number,
  ): Promise<string> => {
    const screen = await screenAfter(headerOf('zbuffer'), ...buffered.slice(0, steps));
    return texts.en.history.spoken([x, y], factsAt(screen, [x, y], owners));
  };

  it('is not painted at first', async () => {
    expect(await said([3, 4], null, 0)).toBe('Pixel (3, 4): not painted yet');
  });

  it('is background once the Z-buffer is cleared', async () => {
    expect(await said([3, 4], null, 1)).toBe('Pixel (3, 4): background, #ffffff, depth −∞');
  });

  it('has its polygon, its colour, and the depth in the Z-buffer', async () => {
    expect(await said([3, 1], only('A'), 4)).toBe('Pixel (3, 1): A, #112233, depth 0.25');
    const screen = await screenAfter(headerOf('zbuffer'), ...buffered);
    expect(texts.ru.history.spoken([3, 1], factsAt(screen, [3, 1], only('A')))).toBe(
      'Пиксель (3; 1): A, #112233, глубина 0,25',
    );
  });

  it('has the depth of the polygon without a Z-buffer: that of its plane at the centre', async () => {
    // The plane z = x / 4, at (1.5, 0.5).
    const vertices = [
      [0, 0, 0],
      [4, 0, 1],
      [0, 4, 0],
    ];
    const ramp = { ...squares.scene.polygons[0], vertices };
    const scene = { ...squares.scene, polygons: [ramp] };
    const plain = await screenAfter({ ...squares, scene }, fill(2, 1, '#112233'));
    expect(texts.en.history.spoken([1, 0], factsAt(plain, [1, 0], only('A')))).toBe(
      'Pixel (1, 0): A, #112233, depth ≈0.375',
    );
    // The mistake turns the picture upside down: the pixel shows another point of the polygon.
    const flipped = factsAt(plain, [1, 0], only('A'), 'y-flipped');
    expect(texts.en.history.spoken([1, 0], flipped)).toBe('Pixel (1, 0): A, #112233');
  });

  it('names all polygons that a pixel may show if the trace does not say which', async () => {
    const plain = await screenAfter(squares, fill(1, 1, '#112233'));
    const owners = { polygons: ['A', 'B'], background: true };
    expect(texts.en.history.spoken([0, 0], factsAt(plain, [0, 0], owners))).toBe(
      'Pixel (0, 0): A or B or background, #112233',
    );
  });

  it('may name the background', async () => {
    const plain = await screenAfter(squares, fill(8, 8, '#ffffff'));
    const owners = { polygons: [], background: true };
    expect(texts.en.history.spoken([0, 0], factsAt(plain, [0, 0], owners))).toBe(
      'Pixel (0, 0): background, #ffffff',
    );
  });
});
