import type { HistoryTexts } from '../../language/texts.js';
import { approximately, short } from '../../language/words.js';

export const history: HistoryTexts = {
  pixel: 'Pixel',
  at: (x, y) => `Pixel (${x}, ${y})`,
  spoken: ([x, y], { color, owners: { polygons, background }, depth, isStored }) => {
    const owner = [...polygons, ...(background ? ['background'] : [])].join(' or ');
    const painted = color === null ? ['not painted yet'] : [owner, color].filter(Boolean);
    const depths =
      depth === null ? [] : [`depth ${isStored ? short(depth) : approximately(short(depth))}`];
    return `Pixel (${x}, ${y}): ${[...painted, ...depths].join(', ')}`;
  },
  hint: (key) =>
    `Click a pixel of the picture${key === null ? '' : `, or press ${key},`} to see everything that affected it and why it has its colour.`,
  how: 'Arrow keys move by one pixel, with Shift by ten. Enter shows the history of the pixel. Escape leaves the picture.',
  forget: 'Forget the pixel',
  entries: 'Everything that affected the pixel',
  outcomes: { pass: 'yes', fail: 'no', paint: 'painted', wrong: 'wrong', note: '' },
  painted: (step) => `Last painted at step ${step}`,
  unpainted: 'Nothing painted it.',
  reading: 'Going through the trace…',
  earlier: (n) => `${n} earlier`,
  later: (n) => `${n} later`,
};
