import { nobody, ownedBy } from '../algorithm/owners.js';
import type { Owners } from '../algorithm/owners.js';
import { toNumber } from '../language/words.js';
import type { Values } from '../replay/values.js';
import type { Event } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import type { Box, Corner, N } from '../trace/values.js';

/** The corner of a window at a point, named as in the text; null if there is none. */
export function cornerAt(at: readonly N[], window: Box | null): Corner | null {
  if (window === null) return null;
  const [x, y, width, height] = window;
  const [px, py] = at.map(toNumber);
  if ((px !== x && px !== x + width) || (py !== y && py !== y + height)) return null;
  if (px === x) return py === y ? 'lb' : 'lt';
  return py === y ? 'rb' : 'rt';
}

/** The sum so far for the edges of an outline: crossings of a ray, or octants. */
export function containment(warnock: Values['warnock']): number {
  return (warnock?.contained ?? []).reduce(
    (sum, edge) => sum + (edge.e === 'ray' ? edge.counts : edge.difference),
    0,
  );
}

/** The polygon that hides all others in the window: the one that was found, or the only one that surrounds it. */
function hidingOf({ warnock }: Pick<Values, 'warnock'>): string | null {
  return warnock?.covering ?? warnock?.joined.surrounding.at(-1)?.polygon ?? null;
}

const background: Owners = { polygons: [], background: true };

/** The lines that fill a window with the background, even if a polygon has that colour. */
const fillsGround: readonly Event<'fill'>['at'][] = ['W7', 'W10', 'WS4', 'WF5', 'WF6'];
/** The lines at which PointColor has found the colour. */
const fillsPoint: readonly Event<'fill' | 'color'>['at'][] = ['W9', 'WS5', 'WF11'];

export function ownersOf(
  { e, at, color }: Event<'fill' | 'color'>,
  known: Pick<Values, 'warnock'>,
  { scene, detail }: Pick<Header, 'scene' | 'detail'>,
): Owners {
  if (e === 'fill' && fillsGround.includes(at)) return background;
  const isPoint = fillsPoint.includes(at);
  const id = isPoint ? (known.warnock?.nearest?.polygon ?? null) : hidingOf(known);
  // A trace that contradicts itself gets no name, only the colour that it records.
  if (id !== null) return scene.byId.get(id)?.color === color ? ownedBy(id) : nobody;
  const isBackground = color === scene.background;
  if (isPoint && isBackground && detail !== 'windows') return background;
  return {
    polygons: scene.polygons.filter((polygon) => polygon.color === color).map(({ id }) => id),
    background: isBackground,
  };
}
