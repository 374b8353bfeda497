import { following, inSteps, isIn, isWhole, moved, wholeOf, zoomed } from '../time/range.js';
import type { Range } from '../time/range.js';
import type { Header } from '../trace/header.js';

/** The ranges last shown for runs, by an identifier of the run. */
const remembered = new Map<string, Range>();

const nameOf = ({ scene, method, edition, kernel, detail }: Header): string =>
  JSON.stringify([scene.name, method, edition, kernel, detail]);

/** The range of a run that the strip shows: the whole until the reader chooses another one, which is remembered. */
export class Zoom {
  private name = '';
  private length = 0;
  private step = 0;
  /** In fractions of steps, so that small turns of a wheel add up; null for the whole. */
  private chosen: Range | null = null;
  private reported: Range = wholeOf(0);

  /**
   * Follows the run as far as it is read, and the current step. When the step changes and leaves the range, the range
   * follows.
   */
  follow(header: Header, length: number, step: number): void {
    const name = nameOf(header);
    if (name !== this.name) {
      this.name = name;
      this.chosen = remembered.get(name) ?? null;
      this.step = step;
    }
    this.length = length;
    if (this.chosen !== null) this.chosen = moved(this.chosen, 0, length);
    if (step !== this.step && this.chosen !== null && !isIn(this.range, step)) {
      this.show(following(this.chosen, step, length));
    }
    this.step = step;
  }

  /** In whole steps; the same object while it stays the same. */
  get range(): Range {
    const { from, to } = inSteps(this.exact);
    if (this.reported.from !== from || this.reported.to !== to) this.reported = { from, to };
    return this.reported;
  }

  get isWhole(): boolean {
    return this.chosen === null;
  }

  show(range: Range): void {
    this.chosen = isWhole(range, this.length) ? null : range;
    if (this.chosen === null) remembered.delete(this.name);
    else remembered.set(this.name, this.chosen);
  }

  showWhole(): void {
    this.show(wholeOf(this.length));
  }

  /** Magnifies by a factor around a place, given as a share of the strip. Without a place it is the step, or the middle. */
  zoom(by: number, place?: number): void {
    const { exact, length } = this;
    const share = place ?? (isIn(exact, this.step) ? null : 0.5);
    const at = share === null ? this.step : exact.from + share * (exact.to - exact.from);
    this.show(zoomed(exact, by, at, length));
  }

  /** Moves the range later by a share of its length. */
  move(share: number): void {
    const { exact, length } = this;
    this.show(moved(exact, share * (exact.to - exact.from), length));
  }

  private get exact(): Range {
    return this.chosen ?? wholeOf(this.length);
  }
}

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
