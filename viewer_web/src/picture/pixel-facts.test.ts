import { describe, expect, it } from 'vitest';
import type { Owners } from '../algorithm/owners.js';
import { texts } from '../i18n/index.js';
import { Screen } from '../replay/screen.js';
import { headerOf } from '../testing/traces.js';
import { parseHeader } from '../trace/header.js';
import { factsAt } from './pixel-facts.js';

/** The background is #ffffff, A is #112233, B #445566. */
const { scene } = parseHeader(headerOf('zbuffer'));

const only = (id: string): Owners => ({ polygons: [id], background: false });

describe('the spoken text of a pixel', () => {
  const screen = new Screen(scene, true);
  const said = (x: number, y: number, owners: Owners | null): string =>
    texts.en.history.spoken([x, y], factsAt(screen, [x, y], owners));

  it('is not painted at first', () => {
    expect(said(3, 4, null)).toBe('Pixel (3, 4): not painted yet');
  });

  it('is background once the Z-buffer is cleared', () => {
    screen.clear('#ffffff', '-inf');
    expect(said(3, 4, null)).toBe('Pixel (3, 4): background, #ffffff, depth −∞');
    const earlier = new Screen(scene, true).save();
    const now = screen.save();
    screen.load(earlier);
    expect(said(3, 4, null)).toBe('Pixel (3, 4): not painted yet');
    screen.load(now);
    expect(said(3, 4, null)).toContain('background');
  });

  it('has its polygon, its colour, and the depth in the Z-buffer', () => {
    screen.paint(2, 1, 3, 1, '#112233');
    screen.z?.set(3, 1, 0.25);
    expect(said(3, 1, only('A'))).toBe('Pixel (3, 1): A, #112233, depth 0.25');
    expect(texts.ru.history.spoken([3, 1], factsAt(screen, [3, 1], only('A')))).toBe(
      'Пиксель (3; 1): A, #112233, глубина 0,25',
    );
  });

  it('has the depth of the polygon without a Z-buffer: that of its plane at the centre', () => {
    // The plane z = x / 4, at (1.5, 0.5).
    const [a] = scene.polygons;
    if (a === undefined) throw new Error('a square');
    const ramp = {
      ...a,
      vertices: [
        [0, 0, 0],
        [4, 0, 1],
        [0, 4, 0],
      ] as const,
    };
    const plain = new Screen({ ...scene, polygons: [ramp], byId: new Map([[a.id, ramp]]) }, false);
    plain.paint(1, 0, 1, 1, a.color);
    expect(texts.en.history.spoken([1, 0], factsAt(plain, [1, 0], only('A')))).toBe(
      'Pixel (1, 0): A, #112233, depth ≈0.375',
    );
    // The mistake turns the picture upside down: the pixel shows another point of the polygon.
    const flipped = factsAt(plain, [1, 0], only('A'), 'y-flipped');
    expect(texts.en.history.spoken([1, 0], flipped)).toBe('Pixel (1, 0): A, #112233');
  });

  it('names all polygons that a pixel may show if the trace does not say which', () => {
    const plain = new Screen(scene, false);
    plain.paint(0, 0, 1, 1, '#112233');
    const owners = { polygons: ['A', 'B'], background: true };
    expect(texts.en.history.spoken([0, 0], factsAt(plain, [0, 0], owners))).toBe(
      'Pixel (0, 0): A or B or background, #112233',
    );
  });

  it('may name the background', () => {
    const plain = new Screen(scene, false);
    plain.paint(0, 0, 8, 8, '#ffffff');
    const owners = { polygons: [], background: true };
    expect(texts.en.history.spoken([0, 0], factsAt(plain, [0, 0], owners))).toBe(
      'Pixel (0, 0): background, #ffffff',
    );
  });
});
