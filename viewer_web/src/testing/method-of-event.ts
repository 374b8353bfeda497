import { listingsOf } from '../listing/listings.js';
import { methods, tells } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';

/** The labels of the lines that a method runs. */
const linesOf = (method: Method): readonly string[] =>
  listingsOf({ method, edition: 'corrected', detail: 'signs' }, 'en').flatMap(({ lines }) =>
    lines.map(({ at }) => at),
  );
const linesByMethod = new Map(methods.map((method) => [method, linesOf(method)]));

/** A method whose runs have such an event at its line. */
export function methodOf({ e, at }: Event): Method {
  const reporting = methods.filter((method) => tells(method, e));
  const method =
    reporting.find((method) => linesByMethod.get(method)?.includes(at)) ?? reporting[0];
  if (method === undefined) throw new Error(`no method tells ${e}`);
  return method;
}
