import { describe, expect, it } from 'vitest';
import { fit } from './fitting.js';
import type { Wide } from './fitting.js';

/** What is so wide at its full size, of which some does not get smaller, in a box of 400. */
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
  it('that has room stays as it is', () => {
    const { it: formula, size } = wide(400);
    fit(formula);
    expect(size()).toBe(1);
  });

  it('that is too wide is made smaller until its end is in sight, also if not all of it gets smaller', () => {
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
