import { hasWindows } from './events.js';
import type { Method } from './events.js';

/** What a method goes through, one after the other: this decides what the page shows of its runs. */
export type MethodKind = 'windows' | 'scanlines' | 'curves';

export function methodKindOf(method: Method): MethodKind {
  if (hasWindows(method)) return 'windows';
  return method === 'zbuffer' ? 'scanlines' : 'curves';
}
