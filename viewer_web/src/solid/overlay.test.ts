import { describe, expect, it } from 'vitest';
import { Frame } from '../picture/frame.js';
import type { Label } from './drawing.js';
import { textsOf } from './overlay.js';
import { views } from './turn.js';

// 100 x 100 with a margin of 7 on 114 CSS pixels: one per unit, from -7 to 107.
const frame = new Frame({ x: 0, y: 0, width: 100, height: 100 }, { width: 114, height: 114 });
const label = (x: number, side: Label['side']): Label => ({ text: 'lb 1', at: [x, 50, 0], side });

describe('a label', () => {
  // Four letters of 0.61 x 11.5 are 28.06 wide. With a gap of 8, the centre is 22.03 beside the point.
  it('is beside its point', () => {
    const [text] = textsOf([label(50, [1, -1])], views.front, frame);
    expect(text?.x).toBeCloseTo(50 + 22.03);
    expect(text?.y).toBeCloseTo(50 - 11.5);
  });

  it('is on the other side where it would be cut off', () => {
    // From 80 it would reach to 80 + 8 + 28.06 > 107.
    const [text] = textsOf([label(80, [1, 0])], views.front, frame);
    expect(text?.x).toBeCloseTo(80 - 22.03);
  });

  it('is on the other side, or a line above, where there is another one', () => {
    // One label fits on either side of the point; the third is one line, 11.5, higher.
    const same = label(50, [1, 0]);
    const texts = textsOf([same, same, same], views.front, frame);
    expect(texts.map(({ x }) => Math.round(x))).toEqual([72, 28, 72]);
    expect(texts.map(({ y }) => y)).toEqual([50, 50, 38.5]);
  });
});
