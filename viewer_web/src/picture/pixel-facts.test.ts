import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { Screen } from '../replay/screen.js';
import { headerOf } from '../testing/traces.js';
import { parseHeader } from '../trace/header.js';
import { factsAt } from './pixel-facts.js';

/** The background is #ffffff, A is #112233, B #445566. */
const { scene } = parseHeader(headerOf('zbuffer'));

describe('the spoken text of a pixel', () => {
  const screen = new Screen(scene, true);
  const said = (x: number, y: number): string =>
    texts.en.history.spoken([x, y], factsAt(screen, [x, y]));

  it('is not painted at first', () => {
    expect(said(3, 4)).toBe('Pixel (3, 4): not painted yet');
  });

  it('has its colour, its polygon, and the depth in the Z-buffer', () => {
    screen.clear('#ffffff', '-inf');
    screen.paint(2, 1, 3, 1, '#112233');
    screen.z?.set(3, 1, 0.25);
    screen.paint(0, 7, 1, 1, '#abcdef');
    expect(said(3, 1)).toBe('Pixel (3, 1): #112233, the colour of A, depth 0.25');
    expect(said(0, 7)).toBe('Pixel (0, 7): #abcdef, depth −∞');
    expect(texts.ru.history.spoken([3, 1], factsAt(screen, [3, 1]))).toBe(
      'Пиксель (3; 1): #112233, цвет A, глубина 0,25',
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
    expect(texts.en.history.spoken([1, 0], factsAt(plain, [1, 0]))).toBe(
      'Pixel (1, 0): #112233, the colour of A, depth ≈0.375',
    );
  });

  it('may name several polygons of a colour', () => {
    const [a, b] = scene.polygons;
    if (a === undefined || b === undefined) throw new Error('two squares');
    const alike = new Screen({ ...scene, polygons: [a, { ...b, color: a.color }] }, false);
    alike.paint(0, 0, 1, 1, a.color);
    expect(texts.en.history.spoken([0, 0], factsAt(alike, [0, 0]))).toBe(
      'Pixel (0, 0): #112233, the colour of A and B',
    );
  });

  it('may name the background', () => {
    const plain = new Screen(scene, false);
    plain.paint(0, 0, 8, 8, '#ffffff');
    expect(texts.en.history.spoken([0, 0], factsAt(plain, [0, 0]))).toBe(
      'Pixel (0, 0): #ffffff, the background',
    );
  });
});
