import { texts } from '../i18n/index.js';
import type { Pixel } from '../picture/pixel.js';
import type { Box, Corner } from '../trace/values.js';
import { algorithmOf } from './algorithm.js';
import { numbersOf } from './view.js';
import type { View } from './view.js';

/**
 * What can be pointed at, wherever the page shows it: a polygon, an edge of the current polygon, a corner of the current
 * window, a window, the pixel that a question is about, a curve, or a column. Its elements carry it as `data-thing`: its
 * kind, a space, and its identifier.
 */
export type Thing =
  | { readonly kind: 'polygon'; readonly id: string }
  | { readonly kind: 'edge'; readonly edge: number }
  | { readonly kind: 'corner'; readonly corner: Corner }
  | { readonly kind: 'window'; readonly window: Box }
  | { readonly kind: 'pixel'; readonly at: Pixel }
  | { readonly kind: 'curve'; readonly curve: number }
  | { readonly kind: 'column'; readonly x: number };

export const polygonThing = (id: string): string => `polygon ${id}`;
export const edgeThing = (edge: number): string => `edge ${edge}`;
export const cornerThing = (corner: Corner): string => `corner ${corner}`;
export const windowThing = (window: Box): string => `window ${window.join(' ')}`;
export const curveThing = (curve: number): string => `curve ${curve}`;
export const columnThing = (x: number): string => `column ${x}`;
export const pixelThing = (at: Pixel): string => `pixel ${at.join(' ')}`;

/** The thing that a text denotes; null if the step does not have it. */
export function thingOf(text: string | null, view: View): Thing | null {
  if (text === null) return null;
  const kind = text.slice(0, text.indexOf(' '));
  const which = text.slice(kind.length + 1);
  if (kind === 'column') return columnOf(Number(which), view);
  if (!thingsOf(view).includes(text)) return null;
  if (kind === 'polygon') return { kind, id: which };
  if (kind === 'edge') return { kind, edge: Number(which) };
  if (kind === 'corner') return { kind, corner: which as Corner };
  if (kind === 'curve') return { kind, curve: Number(which) };
  const numbers: unknown = which.split(' ').map(Number);
  if (kind === 'pixel') return { kind, at: numbers as Pixel };
  return { kind: 'window', window: numbers as Box };
}

/** Everything that can be pointed at in a step, in the order of the keyboard. */
export function thingsOf(view: View): readonly string[] {
  const { header, asked = [] } = view;
  const polygons = header.scene.polygons.map(({ id }) => polygonThing(id));
  return [...new Set([...polygons, ...algorithmOf(header).things(view), ...asked])];
}

function columnOf(x: number, { columns, header }: View): Thing | null {
  const { area } = header.scene;
  const isThere = columns !== null && x >= area.x && x < area.x + area.width;
  return isThere ? { kind: 'column', x } : null;
}

/** The name of the pointed thing; empty if there is none. */
export function sayThing(view: View): string {
  const thing = thingOf(view.pointed, view);
  const { things } = view.texts;
  if (thing === null) return '';
  if (thing.kind === 'polygon') return things.polygon(thing.id);
  if (thing.kind === 'edge') return things.edge(thing.edge);
  if (thing.kind === 'corner') return things.corner(texts[view.language].places[thing.corner]);
  if (thing.kind === 'curve') return texts[view.language].curves.curve(thing.curve);
  if (thing.kind === 'column') return texts[view.language].curves.history.at(thing.x);
  if (thing.kind === 'pixel') return texts[view.language].history.at(...thing.at);
  return things.window(numbersOf(view).windowText(thing.window));
}

/** The thing after or before another. From none it is the first or the last; past the ends it is none. */
export function nextThing(text: string | null, by: 1 | -1, view: View): string | null {
  const all = [null, ...thingsOf(view)];
  const at = Math.max(0, all.indexOf(text));
  return all.at((at + by) % all.length) ?? null;
}

/** The thing under a mouse event, if any. */
export function thingAt(event: Event): string | null {
  const shown = event
    .composedPath()
    .find((each) => each instanceof Element && 'thing' in dataOf(each));
  return shown instanceof Element ? (dataOf(shown)['thing'] ?? null) : null;
}

const dataOf = (element: Element): DOMStringMap =>
  element instanceof HTMLElement || element instanceof SVGElement ? element.dataset : {};
