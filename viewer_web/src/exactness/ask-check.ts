/** Requests a check of the run from the owner of the library, from anywhere in the player. */
export function askCheck(from: EventTarget): void {
  from.dispatchEvent(new Event('vidno-check', { bubbles: true, composed: true }));
}
