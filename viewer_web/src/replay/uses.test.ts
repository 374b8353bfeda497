import { expect, it } from 'vitest';
import { eventsOf, methods } from '../trace/events.js';
import { bits, fieldsOf, uses } from './uses.js';

it.each(methods)('no two fields of a run of %s share a bit', (method) => {
  const fields = [...new Set(eventsOf[method].flatMap((name) => fieldsOf(uses[name])))];
  expect(new Set(fields.map((field) => bits([field]))).size).toBe(fields.length);
});
