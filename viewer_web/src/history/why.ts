import type { Event } from '../trace/events.js';
import type { Scene } from '../trace/header.js';
import type { Entry } from './entry.js';
import type { History } from './history.js';

/** The ways in which a pixel comes by its colour. */
export type Why =
  'hides' | 'centre' | 'alone' | 'nearest' | 'empty' | 'nothing' | 'beside' | 'untouched';

/** What a window is that gets one colour, by the line that fills it. */
const filled: Readonly<Record<Event<'fill'>['at'], Why>> = {
  ...{ W7: 'empty', WS4: 'empty', WF5: 'empty' },
  ...{ W8: 'hides', WF9: 'hides', WF10: 'hides' },
  ...{ W9: 'centre', WS5: 'centre', WF11: 'centre' },
  ...{ W10: 'beside', WF6: 'beside' },
};

const most = 3;

export interface Reason {
  readonly why: Why;
  /** Whose colour it is; none for the background. */
  readonly polygon: string | null;
}

/** The polygon that the entries of the window name with the colour, or else all that have it: few, as a rule. */
function ownerOf({ step, event }: Entry, history: History, { polygons }: Scene): string | null {
  if (event.e !== 'fill') return null;
  for (let i = history.indexAt(step) - 1; i >= 0; i--) {
    const before = history.entries[i]?.event;
    if (before === undefined || before.e === 'pop') break;
    if ((before.e === 'cover' || before.e === 'nearest') && before.color === event.color) {
      return before.polygon;
    }
  }
  const owners = polygons.filter(({ color }) => color === event.color).map(({ id }) => id);
  if (owners.length === 0) return null;
  return owners.length > most ? `${owners.slice(0, most).join(' / ')} / …` : owners.join(' / ');
}

/** Why the entry that painted the pixel gave it its colour. */
export function reasonOf(entry: Entry, history: History, scene: Scene): Reason {
  const { event, known } = entry;
  if (event.e === 'draw') return { why: 'alone', polygon: event.polygon };
  if (event.e === 'span') return { why: 'nearest', polygon: known.zbuffer?.polygon ?? null };
  if (event.e !== 'fill') return { why: 'untouched', polygon: null };
  const why = filled[event.at];
  if (why === 'empty' || why === 'beside') return { why, polygon: null };
  const polygon = ownerOf(entry, history, scene);
  if (why === 'hides') return { why, polygon };
  return { why: polygon === null ? 'nothing' : 'centre', polygon };
}
