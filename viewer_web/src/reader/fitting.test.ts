import { describe, expect, it } from 'vitest';
import { fit } from './fitting.js';
import type { Wide } from './fitting.js';

/** An element that is `width` wide at its full size, in a box of 400. Its stiff part does not shrink. */
function wide(width: number, stiff = 0): { readonly it: Wide; readonly size: () => number } {
  const values = new Map<string, string>();
  const size = (): number => Number(values.get('--fit') ?? 1);
  const style = {
    removeProperty: (name: string) => values.delete(name),
    setProperty: (name: string, value: string) => values.set(name, value),
  };
  const it = {
    clientWidth: 400,
    get scrollWidth() {
      return Math.max(400, stiff + (width - stiff) * size());
    },
    style,
  };
  return { it: it as unknown as Wide, size };
}

describe('a formula', () => {
  it('that fits keeps its size', () => {
    const { it: formula, size } = wide(400);
    fit(formula);
    expect(size()).toBe(1);
  });

  it('that is too wide shrinks until its end is in sight, even if a part of it does not shrink', () => {
    for (const stiff of [0, 60]) {
      const { it: formula, size } = wide(500, stiff);
      fit(formula);
      expect(formula.scrollWidth).toBeLessThanOrEqual(400);
      expect(size()).toBeGreaterThan(0.7);
    }
  });

  it('stays readable', () => {
    const { it: formula, size } = wide(4000);
    fit(formula);
    expect(size()).toBe(0.6);
  });
});
