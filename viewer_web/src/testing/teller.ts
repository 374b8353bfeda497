import { methods, tells } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';

/** The lines of Weiler and Atherton's algorithm, which shares some events with others. */
const ofRegions = /^(WA|SP|DS|RC|RB|PR)\d/;

/** A method whose runs have such an event at its line. */
export function tellerOf({ e, at }: Event): Method {
  if (ofRegions.test(at)) return 'weiler-atherton';
  const teller = methods.find((method) => tells(method, e));
  if (teller === undefined) throw new Error(`no method tells ${e}`);
  return teller;
}
