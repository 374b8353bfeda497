import type { Numbers } from '../language/texts.js';
import { orderOf, toNumber } from '../language/words.js';
import { half, nearer } from '../listing/notation.js';
import type { Notes } from '../listing/notes.js';
import type { Event, ZBufferEvents } from '../trace/events.js';

const edgeOf = ({ edge }: { readonly edge: number }): string => `e = ${edge}`;
const edgesOf = ({ edges }: { readonly edges: readonly number[] }): string =>
  edges.join(' ') || '∅';

/** The printed text also shows equal depths, but nothing beyond 1. */
function shownBy({ z, stored, shown }: Event<'pixel'>, numbers: Numbers): string {
  const order = orderOf(z, stored);
  if (shown && order === 0) return numbers.shortApart(z, stored).join(' ≥ ');
  return !shown && order === 1 && toNumber(z) > 1
    ? `${numbers.short(z)} > 1`
    : nearer(z, stored, shown, numbers);
}

/** The notes of the events of the Z-buffer algorithm, in the notation of the listing. */
export const notes: Pick<Notes, keyof ZBufferEvents> = {
  clear: null,
  polygon: ({ polygon }) => polygon,
  edge: edgeOf,
  extent: ({ ymin, ymax }, { list }) => list([ymin, ymax]),
  scanline: ({ y }, { short }) => `yₜ = ${short(y)}`,
  ael_add: edgeOf,
  horizontal: edgeOf,
  leave: edgesOf,
  ael_sort: edgesOf,
  line: ({ from, to }, { list }) => list([from[0], to[0]]),
  miss: () => 'true',
  slope: ({ dz }, { short }) => `Δz = ${short(dz)}`,
  columns: ({ first, end }, numbers) => half([first, end], numbers),
  pixel: shownBy,
  span: ({ runs }, numbers) => runs.map((run) => half(run, numbers)).join(' ') || '∅',
  ael_drop: edgesOf,
  ael_step: ({ edge, x }, { short }) => `${edge}: ${short(x)}`,
};
