import { describe, expect, it } from 'vitest';
import { headerOf, parseHeader } from '../testing/traces.js';
import type { Polygon, Scene } from '../trace/header.js';
import { Space } from './space.js';

function sceneOf(...vertices: Polygon['vertices']): Scene {
  const { scene } = parseHeader(headerOf('warnock'));
  return { ...scene, polygons: [{ id: 'A', color: '#112233', vertices }] };
}

describe('the box', () => {
  it('has some depth even for a flat scene', () => {
    // Both squares of the 8 x 8 scene have the depth 1/2: the box has a range of 1/4, drawn as 0.6 of 8 pixels.
    const space = new Space(parseHeader(headerOf('warnock')).scene);
    expect(space.depths).toEqual([0.375, 0.625]);
    expect(space.scale).toBeCloseTo(4.8 / 0.25);
    expect(space.size[2]).toBeCloseTo(4.8);
  });

  it('extends to the planes at the corners of the area', () => {
    // z = x / 8 from 1/4 to 3/4 is 0 and 1 at the corners, with a margin of 0.08 on each side.
    const space = new Space(sceneOf([2, 0, 0.25], [6, 0, 0.75], [6, 8, 0.75], [2, 8, 0.25]));
    expect(space.far).toBeCloseTo(-0.08);
    expect(space.near).toBeCloseTo(1.08);
  });

  it('follows a steep plane by at most the depth range of the scene', () => {
    // From 0 to 1 within two pixels: the planes reach -1.5 and 2.5, and the box ends at -1 and 2, plus a margin of 0.08 of
    // 3.
    const space = new Space(sceneOf([3, 0, 0], [5, 0, 1], [5, 8, 1], [3, 8, 0]));
    expect(space.far).toBeCloseTo(-1.24);
    expect(space.near).toBeCloseTo(2.24);
  });

  it('is centred, with farther places moved to its ends', () => {
    const space = new Space(parseHeader(headerOf('warnock')).scene);
    expect(space.place([4, 4, 0.5])).toEqual([0, 0, 0]);
    // An eighth of depth is half of 4.8.
    const [x, y, z] = space.place([0, 8, -Infinity]);
    expect([x, y]).toEqual([-4, 4]);
    expect(z).toBeCloseTo(-2.4);
    expect(space.place([0, 0, 1000])[2]).toBeCloseTo(2.4);
  });
});
