import { expect, it } from 'vitest';
import { findingMarks, findingSteps } from './finding-marks.js';
import { findingsIn, isSeen, sortedBy } from './finding.js';

const lines = [
  '{"format":"vidno-decisions/1","method":"zbuffer","edition":"corrected","kernel":"float","scene":""}',
  '{"kind":"zero","step":7,"at":"L4","procedure":"ShowLine","polygons":["A"],"pixels":[2,0,1,1],"of":"last_centre","taken":2,"exact":2,"coincidence":"on_pixel_centre","computed":0,"gap":"0/1","sign":0,"ulps":0,"operands":[["x","5/2","5/2"],["low","0/1","0/1"],["end","4/1","4/1"]]}',
  '{"kind":"wrong","step":9,"at":"L4","procedure":"ShowLine","polygons":["A"],"pixels":[0,0,1,1],"of":"first_centre","taken":0,"exact":1,"cause":"drifted","coincidence":"on_pixel_centre","computed":0,"gap":"1/1073741824","sign":1,"ulps":0.015625,"operands":[["x","1/2",null]]}',
  '{"kind":"zero","step":3,"at":"Z3","procedure":"Z-buffer","polygons":["A"],"pixels":[0,0,4,1],"of":"comparison","taken":true,"exact":true,"coincidence":"equal_numbers","computed":0,"gap":"0/1","sign":0,"ulps":0,"operands":[]}',
  '{"kind":"point","step":12,"at":"PL5","procedure":"PolygonClip","polygons":[],"pixels":[0,0,4,1],"off":1.5,"operands":[["x","1/2","2/1"]]}',
  '',
].join('\n');

it('reads the list from the library', () => {
  const found = findingsIn(lines);
  expect(found.map(({ step }) => step)).toEqual([7, 9, 3, 12]);
  expect(found[1]?.operands).toEqual([['x', '1/2', null]]);
  expect(found[3]?.off).toBe(1.5);
  expect(() => findingsIn('\n{"kind":"other"}')).toThrow();
});

it('sorts by step, by kind and by narrowness', () => {
  const steps = (order: 'step' | 'kind' | 'ulps') =>
    sortedBy(order, findingsIn(lines)).map(({ step }) => step);
  expect(steps('step')).toEqual([3, 7, 9, 12]);
  expect(steps('kind')).toEqual([9, 12, 3, 7]);
  // A point has no ulps, so it comes last.
  expect(steps('ulps')).toEqual([3, 7, 9, 12]);
});

it('calls only those decisions narrow that are at most 1024 ulps from zero', () => {
  const narrowBy = (ulps: number): string =>
    `{"kind":"narrow","step":4,"at":"PW3","procedure":"ProcessWindow","polygons":[],"pixels":[0,0,1,1],"of":"box","taken":true,"exact":true,"coincidence":"box_on_window","ulps":${ulps},"operands":[]}`;
  // A quarter of a pixel at 16 is 2^-2 / 2^-48 = 2^46 ulps of a double.
  const found = findingsIn(
    ['{}', narrowBy(1), narrowBy(1024), narrowBy(1025), narrowBy(2 ** 46)].join('\n'),
  );
  expect(found.map(({ ulps }) => ulps)).toEqual([1, 1024]);
});

it('leaves out equal numbers of sorts and boxes', () => {
  expect(
    findingsIn(lines)
      .filter(isSeen)
      .map(({ step }) => step),
  ).toEqual([7, 9, 12]);
});

it('marks single pixels always, and larger areas at their step', () => {
  const found = findingsIn(lines);
  // The wrong decision is on top.
  expect(findingMarks(found, 0)).toEqual([
    { kind: 'box', role: 'zero', box: [2, 0, 1, 1] },
    { kind: 'box', role: 'wrong', box: [0, 0, 1, 1] },
  ]);
  expect(findingMarks(found, 3)).toHaveLength(2);
  expect(
    findingMarks(
      found.slice(0, 1).map((each) => ({ ...each, pixels: [0, 0, 4, 1] as const })),
      7,
    ),
  ).toHaveLength(1);
});

it('marks each place of the strip once for each kind', () => {
  const found = findingsIn(lines);
  expect(findingSteps(found, 12).map(({ step }) => step)).toEqual([7, 9]);
  expect(findingSteps(found, 12, 1)).toEqual([
    { step: 7, kind: 'zero' },
    { step: 9, kind: 'wrong' },
  ]);
});
