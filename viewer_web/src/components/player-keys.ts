import type { Actions } from './keyboard.js';
import type { PlayerElement } from './player.js';

/** What the player does at its keys. */
export function playerActions(player: PlayerElement, { shiftKey }: KeyboardEvent): Actions {
  const { clock, keys, listing, picture, travel } = player;
  const showKeys = { '?': () => player.showKeys() };
  if (keys.open) return showKeys;
  const by = shiftKey ? 10 : 1;
  const way = shiftKey ? 'out' : 'over';
  const goal = shiftKey ? 'bookmark' : undefined;
  return {
    ...showKeys,
    ArrowRight: () => player.moveTo(player.step + by),
    ArrowLeft: () => player.moveTo(player.step - by),
    Home: () => player.moveTo(0),
    End: () => player.moveTo(player.length),
    ' ': () => player.togglePlay(),
    '+': () => clock.changeSpeed(1),
    '=': () => clock.changeSpeed(1),
    '-': () => clock.changeSpeed(-1),
    BracketLeft: () => travel.call(way, -1),
    BracketRight: () => travel.call(way, 1),
    Comma: () => travel.next(-1, goal),
    Period: () => travel.next(1, goal),
    KeyB: () => void player.openBookmarks(shiftKey ? 'enter' : 'mark'),
    KeyC: () => listing.toggleSource(),
    KeyO: () => player.point(shiftKey ? -1 : 1),
    KeyP: () => picture.startChoosing(),
  };
}
