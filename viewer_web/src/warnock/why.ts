import type { Entry } from '../history/entry.js';
import type { Reason, Why } from '../history/why.js';
import type { Known } from '../language/words.js';
import type { Event } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { ownersOf } from './naming.js';

/** The reason why a window gets one colour, by the line that fills it. */
const filled: Readonly<Record<Event<'fill'>['at'], Why>> = {
  ...{ W7: 'empty', WS4: 'empty', WF5: 'empty' },
  ...{ W8: 'hides', WF9: 'hides', WF10: 'hides' },
  ...{ W9: 'centre', WS5: 'centre', WF11: 'centre' },
  ...{ W10: 'beside', WF6: 'beside' },
};

const most = 3;

/** The polygon with the colour, or all with that colour if the trace does not say which; null for the background. */
function ownerOf(event: Event<'fill'>, known: Known, header: Header): string | null {
  const { polygons } = ownersOf(event, known, header);
  if (polygons.length === 0) return null;
  return polygons.length > most
    ? `${polygons.slice(0, most).join(' / ')} / …`
    : polygons.join(' / ');
}

/** The reason why the entry that painted the pixel gave it its colour. */
export function why({ event, known }: Entry, header: Header): Reason {
  if (event.e === 'draw') return { why: 'alone', polygon: event.polygon };
  if (event.e !== 'fill') return { why: 'untouched', polygon: null };
  const reason = filled[event.at];
  if (reason === 'empty' || reason === 'beside') return { why: reason, polygon: null };
  const polygon = ownerOf(event, known, header);
  if (reason === 'hides') return { why: reason, polygon };
  return { why: polygon === null ? 'nothing' : 'centre', polygon };
}
