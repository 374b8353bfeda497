import type { Zoom } from './zoom.js';

/** The factor by which a key zooms a run, and the share of the visible part by which another key moves it. */
const [nearer, page] = [2, 0.9];

/** Runs the action of a key on the visible part of a run; returns whether the key has one. */
export function zoomByKey(
  { key, ctrlKey, metaKey, altKey, shiftKey }: KeyboardEvent,
  zoom: Zoom,
): boolean {
  if (ctrlKey || metaKey || altKey) return false;
  const actions: Readonly<Record<string, () => void>> = {
    '+': () => zoom.zoom(nearer),
    '=': () => zoom.zoom(nearer),
    '-': () => zoom.zoom(1 / nearer),
    '0': () => zoom.showWhole(),
    // If the whole is shown, Escape means what it does elsewhere; so do the page keys, which a presenter remote has.
    ...(zoom.isWhole ? {} : { Escape: () => zoom.showWhole() }),
    ...(shiftKey ? { PageUp: () => zoom.move(page), PageDown: () => zoom.move(-page) } : {}),
  };
  const act = actions[key];
  act?.();
  return act !== undefined;
}
