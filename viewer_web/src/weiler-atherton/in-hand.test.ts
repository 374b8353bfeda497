import { expect, it } from 'vitest';
import { figureFrame } from '../picture/figure.js';
import { textOf, traceOf } from '../testing/traces.js';
import { viewOf } from '../algorithm/view.js';
import { allLayers } from './layers.js';
import { listInHand } from './in-hand.js';
import { regionShapes } from './shapes.js';

const shown = { language: 'en', pixel: null, pointed: null } as const;

it.each(['windows', 'polygons', 'signs'])(
  'no list is current while regions are painted, at level %s',
  async (detail) => {
    const trace = await traceOf(textOf(`wedge.weiler-atherton.${detail}.jsonl`));
    const { timeline } = trace;
    const views = Array.from({ length: timeline.length }, (_, i) => viewOf(trace, i + 1, shown));
    const ofLists = views.filter(({ event }) => event?.e === 'show');
    const ofPainting = views.filter(({ event }) => event?.e === 'paint' || event?.e === 'painted');
    expect(ofLists.length).toBeGreaterThan(0);
    expect(ofPainting.length).toBeGreaterThan(1);
    expect(ofPainting.map(listInHand)).toEqual(ofPainting.map(() => null));
    expect(ofLists.map(listInHand)).not.toContain(null);
    const looks = ofPainting.flatMap((view) =>
      regionShapes(view, figureFrame(view), allLayers)
        .filter(({ d }) => d !== '')
        .map(({ look }) => look),
    );
    expect(looks).not.toContain('clip-region');
    // The program's variable keeps the last list, and so do the states of a trace.
    expect(ofPainting.every(({ after }) => after.weilerAtherton?.inHand !== null)).toBe(true);
  },
);
