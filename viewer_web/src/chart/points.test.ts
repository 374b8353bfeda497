import { describe, expect, it } from 'vitest';
import { runOf, sample, sceneOf } from '../testing/charts.js';
import { costs, errors } from './format.js';
import { frontOf } from './front.js';
import { areaOfRight, linesOf, pointsOf } from './points.js';
import { viewsOf } from './views.js';

describe('the front', () => {
  const front = (...places: readonly (readonly [number, number])[]): readonly number[] => {
    const all = places.map(([cost, error]) => ({ cost, error }));
    return [...frontOf(all)].map((place) => all.indexOf(place)).sort();
  };

  it('is of those that no other beats in cost or error and equals in the other', () => {
    expect(front([1, 5], [2, 3], [2, 4], [3, 3], [4, 0], [5, 0])).toEqual([0, 1, 4]);
  });

  it('holds the first of those that are equal', () => {
    expect(front([1, 2], [1, 1], [1, 1], [2, 1])).toEqual([1]);
  });

  it('may begin with what is infinitely wrong', () => {
    expect(front([1, Infinity], [2, Infinity], [3, 7])).toEqual([0, 2]);
    expect(front()).toEqual([]);
  });

  it.each(
    sample.scenes.flatMap((scene) => costs.map((cost) => [scene.name, cost, scene] as const)),
  )('of %s by %s is what the file says', (_name, cost, scene) => {
    for (const error of errors) {
      const { points } = pointsOf([scene], cost, error);
      expect(frontOf(points)).toEqual(new Set(points.filter(({ front: on }) => on)));
    }
  });
});

describe('a scene', () => {
  const run = runOf({ wrongPixels: 3, area: 7, decisions: 8, wrongDecisions: 2, depthUlps: 9 });

  it.each([
    ['wrongPixels', 0.03],
    ['area', 0.07],
    ['wrongDecisions', 0.25],
    ['depthUlps', 9],
  ] as const)('has %s as a share, depths in ulps', (error, share) => {
    expect(pointsOf([sceneOf([run])], 'time', error).points).toMatchObject([{ error: share, run }]);
  });

  it('has no place for what has no number, nor for nothing', () => {
    const runs = [runOf({ bits: null }), runOf({ bits: 0 }), runOf({ bits: 1 })];
    const { points, missing } = pointsOf([sceneOf(runs)], 'bits', 'area');
    expect([points.length, missing.length]).toEqual([1, 2]);
  });

  it('without decisions has no wrong ones', () => {
    const { points } = pointsOf([sceneOf([runOf({ decisions: 0 })])], 'time', 'wrongDecisions');
    expect(points[0]?.error).toBe(0);
  });
});

describe('scenes together', () => {
  const float = { kernel: 'float' };
  const one = sceneOf([
    runOf({ time: 4, operations: 100, wrongPixels: 10, depthUlps: 2 }),
    runOf({ ...float, time: 1, operations: 50, wrongPixels: 100, depthUlps: 4 }),
    runOf({ kernel: 'exact', operations: 100, bits: null }),
  ]);
  const other = sceneOf(
    [
      runOf({ ...float, time: 1, operations: 7, wrongPixels: 0, depthUlps: Infinity }),
      runOf({ time: 9, operations: 28, wrongPixels: 90, depthUlps: 3 }),
    ],
    { pixels: 300 },
  );

  const found = (...args: readonly [(typeof costs)[number], (typeof errors)[number]]): unknown[] =>
    pointsOf([one, other], ...args).points.map(({ setting, cost, error, front }) => [
      setting.kernel,
      Number(cost.toFixed(9)),
      Number(error.toFixed(9)),
      front,
    ]);

  it('have geometric means of ratios, and means of shares', () => {
    expect(found('time', 'wrongPixels')).toEqual([
      ['double', 6, 0.2, true],
      ['float', 1, 0.5, true],
    ]);
    const ratio = Number(Math.sqrt(8).toFixed(9));
    expect(found('operations', 'wrongPixels')).toEqual([
      ['double', ratio, 0.2, true],
      ['float', 1, 0.5, true],
    ]);
  });

  it('have the farthest of depths', () => {
    expect(found('time', 'depthUlps')).toEqual([
      ['double', 6, 3, true],
      ['float', 1, Infinity, true],
    ]);
  });

  it('leave out what did not run in each', () => {
    const { missing } = pointsOf([one, other], 'time', 'area');
    expect(missing.map(({ kernel }) => kernel)).toEqual(['exact']);
  });

  it('have no front of runs that a fault ended', () => {
    const cheap = runOf({ kernel: 'float', time: 0.5 });
    const scenes = [cheap, { ...cheap, complete: false }].map((run) => sceneOf([run, runOf({})]));
    const { points } = pointsOf(scenes, 'time', 'area');
    expect(points.map(({ complete, front: on }) => [complete, on])).toEqual([
      [false, false],
      [true, true],
    ]);
  });

  it('have the mean area of their right pictures', () => {
    const scenes = [sceneOf([], { area: 1 }), sceneOf([], { area: 9, pixels: 300 })];
    expect(areaOfRight(scenes, 'area')).toBeCloseTo(0.02);
    expect(areaOfRight(scenes, 'wrongPixels')).toBeNull();
  });
});

describe('views', () => {
  it('are all of a kind where there are two, and each scene', () => {
    expect(viewsOf(sample).map(({ id }) => id)).toEqual([
      'ordinary',
      'ordinary/Two walls',
      'ordinary/Roofs <and> hills',
      'degenerate/Slivers',
    ]);
  });

  it('tell scenes of one name apart', () => {
    const scenes = [sceneOf([]), sceneOf([])];
    const ids = viewsOf({ ...sample, scenes }).map(({ id }) => id);
    expect(ids).toEqual(['ordinary', 'ordinary/Square', 'ordinary/Square (2)']);
  });
});

describe('lines', () => {
  it('join the runs of a knob in the order of its value', () => {
    const turned = (value: number, edition: 'corrected' | 'printed'): ReturnType<typeof runOf> =>
      runOf({ kernel: `bits:${value}`, knob: 'bits', value, edition });
    const runs = [
      turned(10, 'corrected'),
      runOf({}),
      turned(9, 'printed'),
      turned(4, 'corrected'),
      turned(24, 'corrected'),
    ];
    const { points } = pointsOf([sceneOf(runs)], 'time', 'area');
    const values = linesOf(points).map((line) => line.map(({ setting }) => setting.value));
    expect(values).toEqual([[4, 10, 24], [9]]);
  });
});
