import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { beyond } from './beyond.js';
import { Frame } from './frame.js';
import { point } from './mark.js';

// 100 x 100 units with a margin of 7 in a box of 1140: 10 CSS pixels per unit.
const frame = new Frame({ x: 0, y: 0, width: 100, height: 100 }, { width: 1140, height: 1140 });
const { numbers } = texts.en;

describe('points of a step that are out of sight', () => {
  it('have an arrow at the nearest edge, and their coordinates beside it', () => {
    const { shapes, labels } = beyond([point('no', [50, -107])], frame, numbers);
    // The tip is 3 CSS pixels from the edge at -7; the arrow is 14 long and 14 wide.
    expect(shapes.map(({ look }) => look)).toEqual(['dot no']);
    const corners = [50, -6.7, 50.7, -5.3, 49.3, -5.3];
    (shapes[0]?.d.match(/-?[\d.]+/g) ?? []).forEach((each, i) => {
      expect(Number(each)).toBeCloseTo(corners[i] ?? NaN);
    });
    // Below the arrow: 28 CSS pixels from the edge.
    expect(labels.map(({ text }) => text)).toEqual(['(50, −107)']);
    const inRussian = beyond([point('no', [50.5, -107])], frame, texts.ru.numbers);
    expect(inRussian.labels.map(({ text }) => text)).toEqual(['(50,5; −107)']);
    expect(labels[0]?.at[0]).toBeCloseTo(50);
    expect(labels[0]?.at[1]).toBeCloseTo(-4.2);
  });

  it('have one arrow each; visible points and points of the state have none', () => {
    const far = [point('side', [-50, 50]), point('point', [-50, 50]), point('yes', [-50, 50])];
    expect(beyond([point('yes', [50, 50]), ...far], frame, numbers).shapes).toHaveLength(1);
    expect(beyond([point('edge', [-50, 50])], frame, numbers).labels).toEqual([]);
  });

  it('have none once everything is shown', () => {
    const wide = new Frame(frame.area, frame.size, null, [0, -107, 100, 207]);
    expect(beyond([point('no', [50, -107])], wide, numbers).shapes).toHaveLength(1);
    expect(beyond([point('no', [50, -107])], wide.with(wide.all), numbers).shapes).toEqual([]);
  });
});
