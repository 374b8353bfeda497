import { between, finite, formatOf, list, optional, plainObject, text } from '../trace/check.js';
import type { Check } from '../trace/check.js';
import { Refusal, describe } from '../trace/refusal.js';

/** Checks that charts of scenes and of surfaces share. */

export const format = formatOf('vidno-chart/1');
export const editions = ['corrected', 'printed'] as const;

export const size: Check<number> = (value, path) => {
  const number = finite(value, path);
  if (number >= 0) return number;
  throw new Refusal(path, 'notNegative', describe(value));
};

/** A colour as the page's pictures have it. */
export const color: Check<string> = (value, path) => {
  const found = text(value, path);
  if (/^#[\da-f]{6}$/u.test(found)) return found;
  throw new Refusal(path, 'oneOf', '#rrggbb', describe(value));
};

export const count = between(0, Number.MAX_SAFE_INTEGER);

export function orNull<T>(check: Check<T>): Check<T | null> {
  return (value, path) => (value === null ? null : check(value, path));
}

export function some<T>(item: Check<T>): Check<readonly T[]> {
  const all = list(item);
  return (value, path) => {
    const found = all(value, path);
    if (found.length === 0) throw new Refusal(path, 'emptyList');
    return found;
  };
}

/** A run with a knob has a value of that knob. */
export function runOf<R extends { readonly knob: unknown; readonly value: unknown }>(
  fields: Check<R>,
  setting: Check<number>,
): Check<R> {
  return (value, path) => {
    const run = fields(value, path);
    if (run.knob !== null) setting(run.value, `${path}.value`);
    return run;
  };
}

/** The file of a scene or surface; it need not be included. */
export const file = optional(plainObject);
