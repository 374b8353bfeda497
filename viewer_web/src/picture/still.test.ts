import { describe, expect, it } from 'vitest';
import type { Scene } from '../trace/header.js';
import { Frame } from './frame.js';
import { labelsOf } from './still.js';

const area = { x: 0, y: 0, width: 8, height: 8 };
const frame = new Frame(area, { width: 320, height: 320 });

const sceneOf = (id: string): Scene => ({
  name: '',
  area,
  background: '#ffffff',
  polygons: [{ id, color: '#000000', vertices: [[1, 1, 0]] }],
  byId: new Map(),
  curves: null,
});

describe('the name of a polygon', () => {
  it('is in the picture unchanged', () => {
    expect(labelsOf(sceneOf('roof'), frame)[0]).toMatchObject({ text: 'roof', of: 'roof' });
  });

  it('is shortened where it would cross the picture, and still belongs to its polygon', () => {
    const long = 'я'.repeat(5000);
    const [label] = labelsOf(sceneOf(long), frame);
    expect(label?.text).toBe(`${'я'.repeat(31)}…`);
    expect(label?.of).toBe(long);
  });

  it('lies in the picture even if its first vertex is at the edge', () => {
    const name = 'ABCDEFGHIJKLMNOPQRST';
    const [label] = labelsOf(sceneOf(name), frame);
    // 20 letters of 8 CSS pixels at 35 CSS pixels per unit need 2.3 units on each side of the middle; the picture begins at -0.56.
    expect(label?.at[0]).toBeCloseTo(-0.56 + 2.3, 1);
    expect(label?.at[1]).toBe(1);
  });
});
