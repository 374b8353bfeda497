import { describe, expect, it } from 'vitest';
import { curveRunOf, runOf, sample, sceneOf, surfaceOf, surfaceSample } from '../testing/charts.js';
import { sceneCosts, sceneErrors } from './scene-format.js';
import { areaOfRight, frontOf, linesOf, pointsOf } from './points.js';
import { curveCosts, curveErrors } from './surface-format.js';
import { viewsOf } from './subject.js';

describe('the front', () => {
  const front = (...places: readonly (readonly [number, number])[]): readonly number[] => {
    const all = places.map(([cost, error]) => ({ cost, error }));
    return [...frontOf(all)].map((place) => all.indexOf(place)).sort();
  };

  it('has the points that no other one beats in cost or error while equal or better in the other', () => {
    expect(front([1, 5], [2, 3], [2, 4], [3, 3], [4, 0], [5, 0])).toEqual([0, 1, 4]);
  });

  it('has the first of several equal points', () => {
    expect(front([1, 2], [1, 1], [1, 1], [2, 1])).toEqual([1]);
  });

  it('may begin with an infinite error', () => {
    expect(front([1, Infinity], [2, Infinity], [3, 7])).toEqual([0, 2]);
    expect(front()).toEqual([]);
  });

  it.each(
    sample.scenes.flatMap((scene) => sceneCosts.map((cost) => [scene.name, cost, scene] as const)),
  )('of %s by %s is the one in the file', (_name, cost, scene) => {
    for (const error of sceneErrors) {
      const { points } = pointsOf([scene], cost, error);
      expect(frontOf(points)).toEqual(new Set(points.filter(({ front: on }) => on)));
    }
  });

  it.each(
    surfaceSample.surfaces.flatMap((surface) =>
      curveCosts.map((cost) => [surface.name, cost, surface] as const),
    ),
  )('of %s by %s is the one in the file', (_name, cost, surface) => {
    for (const error of curveErrors) {
      const { points } = pointsOf([surface], cost, error);
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

  it('has no point for a missing cost or a cost of zero', () => {
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

  const found = (
    ...args: readonly [(typeof sceneCosts)[number], (typeof sceneErrors)[number]]
  ): unknown[] =>
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

  it('have the greatest error of depth', () => {
    expect(found('time', 'depthUlps')).toEqual([
      ['double', 6, 3, true],
      ['float', 1, Infinity, true],
    ]);
  });

  it('leave out settings that did not run in all of them', () => {
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

describe('a surface', () => {
  const run = curveRunOf({ wrongColumns: 5, height: 1.5, decisions: 8, wrongDecisions: 2 });

  it.each([
    ['wrongColumns', 0.1],
    ['height', 1.5],
    ['wrongDecisions', 0.25],
  ] as const)('has %s as a share, heights in pixels', (error, share) => {
    const { points } = pointsOf([surfaceOf([run])], 'samples', error);
    expect(points).toMatchObject([{ cost: 6, error: share, complete: true, run }]);
  });

  it('shares a setting with another where the knob has the same value', () => {
    const turned = (value: number, height: number): ReturnType<typeof curveRunOf> =>
      curveRunOf({ knob: 'samples', value, samples: 2 * value, height });
    const surfaces = [
      surfaceOf([turned(3, 1), turned(9, 0)]),
      surfaceOf([turned(2, 9), turned(3, 4), turned(5, 2)], { columns: 10 }),
    ];
    const { points, missing } = pointsOf(surfaces, 'samples', 'height');
    // The first surface has at least 3 samples per curve, the second 2: ratios 1 and 3 / 2.
    expect(points.map(({ setting, error }) => [setting.value, error])).toEqual([[3, 4]]);
    expect(points[0]?.cost).toBeCloseTo(Math.sqrt(1.5));
    expect(missing.map(({ value }) => value)).toEqual([9, 2, 5]);
    expect(areaOfRight(surfaces, 'height')).toBeNull();
  });
});

describe('views', () => {
  it('are all scenes of a kind if there are at least two, and each scene', () => {
    expect(viewsOf(sample).map(({ id }) => id)).toEqual([
      'ordinary',
      'ordinary/Two walls',
      'ordinary/Roofs <and> hills',
      'degenerate/Slivers',
    ]);
  });

  it('of surfaces have no kinds', () => {
    expect(viewsOf(surfaceSample).map(({ id }) => id)).toEqual([
      'surfaces',
      'surfaces/A peak between two samples',
      'surfaces/Ramp <up> & down',
    ]);
  });

  it('distinguish scenes with the same name', () => {
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
