import type { Clock } from '../elements/clock.js';
import type { Actions } from '../elements/keyboard.js';
import type { KeysElement } from '../elements/keys.js';
import type { Side } from '../history/side-name.js';
import type { ListingElement } from '../listing/listing-element.js';
import type { Predictor } from '../predict/predictor.js';
import type { TravelElement } from '../time/travel.js';
import type { PicturePanelElement } from './picture-panel.js';
import type { Presenter } from './presenter.js';

/** What can be moved through time. */
export interface Timed {
  readonly step: number;
  readonly first: number;
  readonly last: number;
  readonly clock: Clock;
  readonly travel: TravelElement;
  moveTo(step: number): void;
  togglePlay(): void;
}

/** The parts of the player that keys control. */
export interface Steered extends Timed {
  readonly trace: unknown;
  readonly controls: string;
  readonly isFull: boolean;
  readonly side: Side;
  readonly presenting: boolean;
  readonly presenter: Presenter;
  readonly predictor: Predictor;
  readonly keys: KeysElement;
  readonly listing: ListingElement;
  readonly picture: PicturePanelElement;
  showKeys(): void;
  present(on: boolean): void;
  point(by: 1 | -1): void;
  toggleSide(side: Side): void;
  escape(): void;
  enterOutline(): Promise<void>;
  openBookmarks(way: 'mark' | 'enter'): Promise<void>;
}

/** The actions of keys on the player. */
export function actionsOf(player: Steered, { shiftKey }: KeyboardEvent): Actions {
  const { trace, controls, keys, presenting, presenter } = player;
  if (trace === null || (controls === 'none' && !presenting)) return {};
  const showKeys = { '?': () => player.showKeys() };
  if (keys.open) return showKeys;
  const usual = { ...showKeys, ...usualActions(player, shiftKey) };
  return presenting ? presenter.actions(usual) : usual;
}

function usualActions(player: Steered, shift: boolean): Actions {
  const { picture } = player;
  return {
    ...timeActions(player, shift),
    ...(player.isFull ? panelActions(player, shift) : {}),
    KeyC: () => player.listing.toggleSource(),
    KeyL: () => picture.nextLayer(),
    KeyO: () => player.point(shift ? -1 : 1),
    KeyP: () => picture.startChoosing(),
    KeyF: () => player.present(!player.presenting),
    KeyS: () => void picture.save(shift ? 'png' : 'svg'),
  };
}

/** What happens in the panels, which a player with few controls does not have. */
function panelActions(player: Steered, shift: boolean): Actions {
  return {
    ...(player.side === 'predict' ? { Escape: () => player.escape() } : {}),
    KeyB: () => void player.openBookmarks(shift ? 'enter' : 'mark'),
    KeyX: () => player.toggleSide('exact'),
    KeyT: () => (shift ? void player.enterOutline() : player.toggleSide('outline')),
    KeyV: () => player.toggleSide('solid'),
    KeyQ: () => player.predictor.next(),
  };
}

/** The moves through time, short and long. */
export function timeActions(player: Timed, shift: boolean): Actions {
  const { clock, travel } = player;
  const by = shift ? 10 : 1;
  const way = shift ? 'out' : 'over';
  const goal = shift ? 'bookmark' : undefined;
  return {
    ArrowRight: () => player.moveTo(player.step + by),
    ArrowLeft: () => player.moveTo(player.step - by),
    Home: () => player.moveTo(player.first),
    End: () => player.moveTo(player.last),
    ' ': () => player.togglePlay(),
    '+': () => clock.changeSpeed(1),
    '=': () => clock.changeSpeed(1),
    '-': () => clock.changeSpeed(-1),
    BracketLeft: () => travel.call(way, -1),
    BracketRight: () => travel.call(way, 1),
    Comma: () => travel.next(-1, goal),
    Period: () => travel.next(1, goal),
  };
}
