import { expect, it } from 'vitest';
import { statesOf, traceIn, tracesWithStates } from '../src/testing/states.js';
import { browser } from './browser.js';
import { open, opened, shown, states } from './page.js';

/** The first trace of each method; `src/replay/every-state.test.ts` compares all traces. */
const some = ['.warnock.', '.zbuffer.', '.weiler-atherton.', '.floating-horizon.']
  .map((method) => tracesWithStates.find((name) => name.includes(method)))
  .filter((name) => name !== undefined);

it.each(some)('%s: the page shows the states of the program', async (name) => {
  const { page } = await open(browser, '#lang=en');
  await opened(page, name, Buffer.from(traceIn(name)));
  const expected = statesOf(name);
  const { length } = await shown(page);
  expect(length).toBe(expected.length - 1);
  expect(await states(page, length + 1)).toEqual(expected);
});
