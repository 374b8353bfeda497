import type { Zoom } from './zoom.js';

/** How much nearer a key brings a run, and by which share of what is shown another key moves it. */
const [nearer, page] = [2, 0.9];

/** Does what a key means for the part of a run that is shown; says whether it means anything. */
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
    // Where the whole is shown it means what it does elsewhere; so do the keys of pages, which a remote control has.
    ...(zoom.isWhole ? {} : { Escape: () => zoom.showWhole() }),
    ...(shiftKey ? { PageUp: () => zoom.move(page), PageDown: () => zoom.move(-page) } : {}),
  };
  const act = actions[key];
  act?.();
  return act !== undefined;
}
