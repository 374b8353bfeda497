/** Asks whoever has the library to check the run, from anywhere in the player. */
export function askCheck(from: EventTarget): void {
  from.dispatchEvent(new Event('vidno-check', { bubbles: true, composed: true }));
}
