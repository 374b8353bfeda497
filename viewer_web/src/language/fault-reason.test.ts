import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { faultReason } from './fault-reason.js';

const library = fileURLToPath(new URL('../../../lib/vidno', import.meta.url));

/** The reasons in the sources of the procedures: `Fault{LINE, "reason"}` and `fault(LINE, "reason"`. */
const reasons = readdirSync(library, { recursive: true })
  .filter((name) => String(name).endsWith('.h'))
  .flatMap((name) => [
    ...readFileSync(join(library, String(name)), 'utf8').matchAll(
      /[Ff]ault[{(][\w:]+, "([^"]+)"/gu,
    ),
  ])
  .map(([, reason]) => reason ?? '');

it('finds the reasons of the procedures', () => {
  expect(reasons).toContain('division by zero');
});

it.each(reasons)('is Russian for every reason of a procedure: %s', (reason) => {
  expect(faultReason('en', reason)).toBe(reason);
  expect(faultReason('ru', reason)).toMatch(/[а-я]/u);
});

it('leaves a reason of another program as it is', () => {
  expect(faultReason('ru', 'out of memory')).toBe('out of memory');
});
