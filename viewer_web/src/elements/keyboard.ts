import type { ReactiveController, ReactiveControllerHost, TemplateResult } from 'lit';
import { html, nothing } from 'lit';
import { keyMap, liveKey } from '../base/key-map.js';

const isSummary = (target: EventTarget | undefined): boolean =>
  target instanceof HTMLElement && target.localName === 'summary';

/** Whether the element in focus handles the key itself. */
export function takesKey(event: KeyboardEvent): boolean {
  const [target] = event.composedPath();
  if (target instanceof HTMLInputElement) {
    if (event.key === 'Escape') return false;
    if (target.type === 'checkbox') return event.key === ' ';
    if (target.type === 'radio') return event.key === ' ' || event.key.startsWith('Arrow');
    return target.type === 'range' ? !['?', ' ', '+', '-'].includes(event.key) : event.key !== '?';
  }
  // A list keeps the focus after a choice, and changes it by the other two arrows, too.
  if (target instanceof HTMLSelectElement) return !/^Arrow(?:Left|Right)$/.test(event.key);
  if (target instanceof HTMLTextAreaElement) return true;
  const isPressed = target instanceof HTMLButtonElement || isSummary(target);
  return isPressed && event.key === ' ';
}

/** The actions of keys, each by its character or else by its place, which is the same in any language. */
export type Actions = Readonly<Record<string, () => void>>;

/** Runs the host's action for a key pressed anywhere in the host. */
export class Keyboard implements ReactiveController {
  constructor(
    private readonly host: ReactiveControllerHost & HTMLElement,
    private readonly actions: (event: KeyboardEvent) => Actions,
    /** Whether it listens wherever the focus is, so that the reader may reassign its keys or turn them off. */
    private readonly isEverywhere = false,
  ) {
    host.addController(this);
  }

  hostConnected(): void {
    this.host.addEventListener('keydown', this.handle);
  }

  hostDisconnected(): void {
    this.host.removeEventListener('keydown', this.handle);
  }

  readonly handle = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (takesKey(event) || (this.isEverywhere && !keyMap.allows(event))) return;
    const code = this.isEverywhere ? keyMap.meant(event.code) : event.code;
    const actions = this.actions(event);
    const act = actions[event.key] ?? actions[code];
    if (act === undefined) return;
    event.preventDefault();
    act();
  };
}

/** The key beside a button with the same function; nothing if single-character keys are off. */
export function kbd(name: string): TemplateResult | typeof nothing {
  const key = liveKey(name);
  return key === null ? nothing : html`<kbd>${key}</kbd>`;
}
