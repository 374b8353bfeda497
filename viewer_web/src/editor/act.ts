import type { Act } from './editor.js';

/** Tells whoever holds the scene what is to be done with it, from anywhere in the player. */
export function act(from: EventTarget, detail: Act): void {
  from.dispatchEvent(new CustomEvent<Act>('vidno-act', { detail, bubbles: true, composed: true }));
}

/** The same of the scene as a whole: to save it as a file, to copy a link to it. */
export function ask(from: EventTarget, what: 'vidno-save' | 'vidno-link'): void {
  from.dispatchEvent(new Event(what, { bubbles: true, composed: true }));
}
