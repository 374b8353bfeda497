import { expect, it } from 'vitest';
import { historyIn } from '../testing/histories.js';
import { grouped } from './groups.js';

it('a painted pixel is listed under its own polygon, not under the clip polygon of the last list', async () => {
  const { entries } = await historyIn('wedge.weiler-atherton.signs', [10, 6]);
  const painted = grouped(entries).flatMap(({ under, entries: own }) =>
    own.flatMap(({ event }) =>
      event.e === 'paint' || event.e === 'order' ? [[under, event.polygon]] : [],
    ),
  );
  expect(painted.length).toBeGreaterThan(0);
  for (const [under, polygon] of painted) expect(under).toBe(polygon);
});
