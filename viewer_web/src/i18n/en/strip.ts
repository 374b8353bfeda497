import type { Range } from '../../time/range.js';

export const strip = {
  step: (step: number, length: number): string => `Step ${step} of ${length}`,
  windowAt: (size: string, at: string): string => `window ${size} at ${at}`,
  polygon: (id: string): string => `polygon ${id}`,
  row: (row: string): string => `row ${row}`,
  bookmark: (note: string): string => (note === '' ? 'bookmark' : `bookmark “${note}”`),
  cases: {
    empty: 'empty',
    surrounded: 'surrounded',
    pixel: 'pixel',
    single: 'single',
    split: 'split',
  },
  marks: { wrong: 'wrong decision', fault: 'the printed text fails' },
  lanes: {
    cases: 'windows',
    polygons: 'polygons',
    curves: 'curves',
    levels: 'levels',
    ael: 'AEL',
    calls: 'calls',
  },
  legend: 'What the strip shows',
  explain: {
    cases: 'Windows, by their case:',
    polygons: 'The current polygon, in its colour: every second one is striped',
    curves: 'The current curve: every second one is striped',
    levels: 'How often the area was split to get the window',
    ael: 'Where the AEL changes',
    calls: 'How deep the calls are nested',
    wrong: 'A wrong decision, if the run was checked',
    fault: 'The printed text fails, or rounding leaves an outline open',
    bookmark: 'A bookmark',
    hit: 'A hit of the search in the outline',
    now: 'The step that is shown',
  },
  zoom: {
    part: 'Strip',
    shown: ({ from, to }: Range, length: number): string =>
      from === 0 && to === length ? 'The whole run' : `Steps ${from} to ${to} of ${length}`,
    toWhole: 'Show the whole run',
    how: 'Drag along this bar to zoom in. On the strip the wheel, two fingers, + and − zoom; 0 shows the whole run.',
  },
  columns:
    'One column of dots stands for many steps: each colour is as tall as its share of them. The greatest level is pale, the mean level is dark. No mark is left out.',
};
