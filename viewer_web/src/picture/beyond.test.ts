import { describe, expect, it } from 'vitest';
import { beyond } from './beyond.js';
import { Frame } from './frame.js';
import { point } from './mark.js';

// 100 x 100 units with a margin of 7 in a box of 1140: 10 CSS pixels a unit.
const frame = new Frame({ x: 0, y: 0, width: 100, height: 100 }, { width: 1140, height: 1140 });

describe('points of a step that are out of sight', () => {
  it('have an arrow at the edge that is nearest to them, and their place beside it', () => {
    const { shapes, labels } = beyond([point('no', [50, -107])], frame);
    // The tip is 3 CSS pixels from the edge at -7, and the arrow 14 long and 14 wide.
    expect(shapes.map(({ look }) => look)).toEqual(['dot no']);
    const corners = [50, -6.7, 50.7, -5.3, 49.3, -5.3];
    (shapes[0]?.d.match(/-?[\d.]+/g) ?? []).forEach((each, i) => {
      expect(Number(each)).toBeCloseTo(corners[i] ?? NaN);
    });
    // Below the arrow: 28 CSS pixels from the edge.
    expect(labels.map(({ text }) => text)).toEqual(['(50, −107)']);
    expect(labels[0]?.at[0]).toBeCloseTo(50);
    expect(labels[0]?.at[1]).toBeCloseTo(-4.2);
  });

  it('have one each, and those in sight none, nor what is there because of the state', () => {
    const far = [point('side', [-50, 50]), point('point', [-50, 50]), point('yes', [-50, 50])];
    expect(beyond([point('yes', [50, 50]), ...far], frame).shapes).toHaveLength(1);
    expect(beyond([point('edge', [-50, 50])], frame).labels).toEqual([]);
  });

  it('have none once all that there is is shown', () => {
    const wide = new Frame(frame.area, frame.size, null, [0, -107, 100, 207]);
    expect(beyond([point('no', [50, -107])], wide).shapes).toHaveLength(1);
    expect(beyond([point('no', [50, -107])], wide.with(wide.all)).shapes).toEqual([]);
  });
});
