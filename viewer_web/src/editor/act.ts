import type { Act } from './editor.js';

/** Requests an edit from whatever owns the scene, from anywhere in the player. */
export function act(from: EventTarget, detail: Act): void {
  from.dispatchEvent(new CustomEvent<Act>('vidno-act', { detail, bubbles: true, composed: true }));
}

/** The same for the whole scene: to save it as a file, or to copy a link to it. */
export function ask(from: EventTarget, what: 'vidno-save' | 'vidno-link'): void {
  from.dispatchEvent(new Event(what, { bubbles: true, composed: true }));
}
