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
  missed: (polygon) => `${polygon} does not cover the centre of this pixel, which stays as it is.`,
  kept: (polygon) => `On this row ${polygon} leaves the pixel as it is.`,
  because: (step) =>
    step === null ? 'Why it has this colour:' : `Why it gets this colour at step ${step}:`,
  why: {
    hides: (polygon) => `${polygon} surrounds this window and hides everything else in it.`,
    centre: (polygon) => `${polygon} is the nearest of all that cover its centre.`,
    alone: (polygon) => `${polygon} is alone in this window and covers the centre of the pixel.`,
    nearest: (polygon) =>
      `${polygon} is nearer here than everything drawn before, and nothing drawn later replaced it.`,
    notFarther: (polygon) =>
      `${polygon} is here at least as near as everything drawn before, and nothing drawn later replaced it.`,
    empty: () => 'no polygon is left in this window.',
    nothing: () => 'no polygon covers its centre.',
    beside: () =>
      'as this run computes it, the only polygon in this window does not cover the centre of the pixel.',
    region: (polygon) => `its centre lies in a visible region, where ${polygon} is the nearest.`,
    untouched: () => 'no polygon was drawn at this pixel.',
  },
  whyBackground: (step) =>
    step === null ? 'Why it is background:' : `Why it becomes background at step ${step}:`,
};
