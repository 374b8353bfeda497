import { algorithmOf } from '../algorithm/algorithm.js';
import { thingOf } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import type { Sight } from '../replay/screen.js';
import { box, path, target } from './mark.js';
import type { Mark } from './mark.js';

function isFinite(mark: Mark): boolean {
  if (mark.kind !== 'point' && mark.kind !== 'note' && mark.kind !== 'path') return true;
  const spots = mark.kind === 'path' ? mark.points : [mark.at];
  return spots.every(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
}

/** The marks of a thing that is pointed at. */
export function marksOfThing(text: string, view: View): readonly Mark[] {
  const thing = thingOf(text, view);
  const { header } = view;
  if (thing === null) return [];
  switch (thing.kind) {
    case 'polygon':
      return [path('pointed', header.scene.byId.get(thing.id)?.vertices ?? [], true)];
    case 'window':
      return [box('pointed', thing.window)];
    case 'pixel':
      return [box('pointed', [...thing.at, 1, 1])];
    case 'edge':
    case 'corner':
    case 'curve':
    case 'column':
      return algorithmOf(header).thingMarks?.(thing, view) ?? [];
  }
}

/** The marks of what is asked about, and of what is pointed at anywhere on the page. */
function pointedMarks(view: View): readonly Mark[] {
  const { asked = [], pointed } = view;
  const things = pointed === null ? asked : [...asked, pointed];
  return things.flatMap((thing) => marksOfThing(thing, view));
}

/** All visible marks of a step; later marks are on top. */
export function marksOf(view: View, sight: Sight): readonly Mark[] {
  const chosen = view.pixel === null ? [] : [target('chosen', view.pixel)];
  const own = algorithmOf(view.header).marks(view, sight);
  const { found = [], explained = [] } = view;
  return [...own, ...found, ...pointedMarks(view), ...chosen, ...explained].filter(isFinite);
}
