import { expect, it } from 'vitest';
import { common, methods, tables } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import { bits, fieldsOf, uses } from './uses.js';

it.each(methods)('no two fields of a run of %s share a bit', (method) => {
  const names = Object.keys({ ...common, ...tables[method] }) as EventName[];
  const fields = [...new Set(names.flatMap((name) => fieldsOf(uses[name])))];
  expect(new Set(fields.map((field) => bits([field]))).size).toBe(fields.length);
});
