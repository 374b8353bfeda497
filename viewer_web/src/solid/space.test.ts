import { describe, expect, it } from 'vitest';
import { headerOf } from '../testing/traces.js';
import { parseHeader } from '../trace/header.js';
import type { Polygon, Scene } from '../trace/header.js';
import { Space } from './space.js';

function sceneOf(...vertices: Polygon['vertices']): Scene {
  const { scene } = parseHeader(headerOf('warnock'));
  return { ...scene, polygons: [{ id: 'A', color: '#112233', vertices }] };
}

describe('the box', () => {
  it('of a flat scene has some depth nevertheless', () => {
    // Both squares of the 8 x 8 scene lie at 1/2: 1/4 in all, and 0.6 of 8 pixels for it.
    const space = new Space(parseHeader(headerOf('warnock')).scene);
    expect(space.depths).toEqual([0.375, 0.625]);
    expect(space.scale).toBeCloseTo(4.8 / 0.25);
    expect(space.size[2]).toBeCloseTo(4.8);
  });

  it('reaches as far as the planes at the corners of the area', () => {
    // z = x / 8 from 1/4 to 3/4 is 0 and 1 at the corners; and 0.08 more to each side.
    const space = new Space(sceneOf([2, 0, 0.25], [6, 0, 0.75], [6, 8, 0.75], [2, 8, 0.25]));
    expect(space.far).toBeCloseTo(-0.08);
    expect(space.near).toBeCloseTo(1.08);
  });

  it('follows a steep plane no further than once more the depth of the scene', () => {
    // From 0 to 1 within two pixels: the planes are at -1.5 and 2.5, the box ends at -1 and 2, and 0.08 of 3 more.
    const space = new Space(sceneOf([3, 0, 0], [5, 0, 1], [5, 8, 1], [3, 8, 0]));
    expect(space.far).toBeCloseTo(-1.24);
    expect(space.near).toBeCloseTo(2.24);
  });

  it('has its middle in the middle, and what is beyond at its ends', () => {
    const space = new Space(parseHeader(headerOf('warnock')).scene);
    expect(space.place([4, 4, 0.5])).toEqual([0, 0, 0]);
    // An eighth of depth is half of 4.8.
    const [x, y, z] = space.place([0, 8, -Infinity]);
    expect([x, y]).toEqual([-4, 4]);
    expect(z).toBeCloseTo(-2.4);
    expect(space.place([0, 0, 1000])[2]).toBeCloseTo(2.4);
  });
});
