import type { Actions } from '../elements/keyboard.js';
import type { KeysElement } from '../elements/keys.js';
import { timeActions } from '../player/player-keys.js';
import type { Timed } from '../player/player-keys.js';
import type { Presenter } from '../player/presenter.js';
import type { ComparedRunElement } from './compared-run.js';

/** The parts of a comparison that keys control. */
export interface SteeredPair extends Timed {
  readonly presenting: boolean;
  readonly presenter: Presenter;
  readonly keys: KeysElement;
  readonly runs: Iterable<ComparedRunElement>;
  showKeys(): void;
  present(on: boolean): void;
  point(by: 1 | -1): void;
  toggle(name: 'mark'): void;
  bookmark(): void;
  goToParting(what: 'text' | 'deed'): void;
}

/** The actions of keys on a comparison: those of a player that apply here. */
export function pairActions(pair: SteeredPair, { shiftKey }: KeyboardEvent): Actions {
  const { keys, presenting, presenter } = pair;
  const [first] = pair.runs;
  const showKeys = { '?': () => pair.showKeys() };
  if (keys.open) return showKeys;
  const usual: Actions = {
    ...showKeys,
    ...timeActions(pair, shiftKey),
    KeyB: () => pair.bookmark(),
    KeyC: () => {
      for (const run of pair.runs) run.toggleSource();
    },
    KeyJ: () => pair.goToParting(shiftKey ? 'text' : 'deed'),
    KeyL: () => pair.toggle('mark'),
    KeyO: () => pair.point(shiftKey ? -1 : 1),
    KeyP: () => first?.startChoosing(),
    KeyF: () => pair.present(!presenting),
    KeyS: () => {
      for (const run of pair.runs) void run.save(shiftKey ? 'png' : 'svg');
    },
  };
  return presenting ? presenter.actions(usual) : usual;
}
