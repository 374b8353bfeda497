import { describe, expect, it } from 'vitest';
import { emptySketch, sceneText } from './sketch.js';
import type { Sketch } from './sketch.js';
import {
  firstSurface,
  formulaOf,
  isSurface,
  moveSample,
  withFormula,
  withoutTolerance,
} from './surface.js';

const curves = [
  [
    [0, 2],
    [4, 2],
  ],
] as const;
const sampled: Sketch = { ...emptySketch, name: 'A line', curves };

describe('a surface that is made', () => {
  it('is written with its samples, or with its function', () => {
    expect(JSON.parse(sceneText(sampled))).toEqual({
      format: 'vidno-surface/1',
      name: 'A line',
      window: { x: 0, y: 0, width: 16, height: 16 },
      curves,
    });
    const text = sceneText(firstSurface('A wave'));
    expect(isSurface(text)).toBe(true);
    expect(formulaOf(text)).toEqual(firstSurface('').formula);
    expect(formulaOf(sceneText(sampled))).toBeUndefined();
  });

  it('is distinguished from other files, wherever its format is stated', () => {
    expect(isSurface('{"window":{"x":0},"format":"vidno-surface/1"}')).toBe(true);
    // Its reader says that it is of another version.
    expect(isSurface('{"format":"vidno-surface/2"}')).toBe(true);
    expect(isSurface('{"scene":{"format":"vidno-surface/1"}}')).toBe(false);
    expect(isSurface('vidno-surface/1')).toBe(false);
  });

  it('has no function after a sample was moved', () => {
    const wave = firstSurface('A wave');
    const moved = moveSample(wave, curves, { curve: 0, sample: 1 }, ([, y]) => y + 1);
    expect(moved.formula).toBeUndefined();
    expect(moved.curves).toEqual([
      [
        [0, 2],
        [4, 3],
      ],
    ]);
    expect(moveSample(wave, curves, { curve: 0, sample: 1 }, ([, y]) => y)).toBe(wave);
    expect(moveSample(sampled, [], { curve: 0, sample: 0 }, () => 1).curves?.[0]?.[0]).toEqual([
      0, 1,
    ]);
  });

  it('has a tolerance, or none', () => {
    const finer = withFormula(firstSurface(''), { tolerance: 0.5 });
    expect(finer.formula?.tolerance).toBe(0.5);
    expect(withoutTolerance(finer).formula).toEqual(firstSurface('').formula);
  });
});
