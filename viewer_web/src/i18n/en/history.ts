import type { Pixel } from '../../picture/pixel.js';
import type { PixelFacts } from '../../picture/pixel-facts.js';
import { approximately, short } from '../../language/words.js';

export const history = {
  pixel: 'Pixel',
  at: (x: number, y: number): string => `Pixel (${x}, ${y})`,
  /** The pixel under the keyboard's cursor, for screen readers. */
  spoken: (
    [x, y]: Pixel,
    { color, owners: { polygons, background }, depth, isStored }: PixelFacts,
  ): string => {
    const owner = [...polygons, ...(background ? ['background'] : [])].join(' or ');
    const painted = color === null ? ['not painted yet'] : [owner, color].filter(Boolean);
    const depths =
      depth === null ? [] : [`depth ${isStored ? short(depth) : approximately(short(depth))}`];
    return `Pixel (${x}, ${y}): ${[...painted, ...depths].join(', ')}`;
  },
  /** Includes the key if single-character keys are on. */
  hint: (key: string | null): string =>
    `Click a pixel of the picture${key === null ? '' : `, or press ${key},`} to see everything that affected it and why it has its colour.`,
  how: 'Arrow keys move by one pixel, with Shift by ten. Enter shows the history of the pixel. Escape leaves the picture.',
  forget: 'Forget the pixel',
  entries: 'Everything that affected the pixel',
  outcomes: { pass: 'yes', fail: 'no', paint: 'painted', wrong: 'wrong', note: '' },
  painted: (step: number): string => `Last painted at step ${step}`,
  unpainted: 'Nothing painted it.',
  reading: 'Going through the trace…',
  earlier: (n: number): string => `${n} earlier`,
  later: (n: number): string => `${n} later`,
};
