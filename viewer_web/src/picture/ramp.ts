import { toPixel } from '../replay/screen.js';

/**
 * Nine colours of viridis (Smith and van der Walt, CC0), evenly spaced in lightness, whatever hues the eye distinguishes.
 */
export const stops = [
  '#440154',
  '#472d7b',
  '#3b528b',
  '#2c728e',
  '#21918c',
  '#28ae80',
  '#5ec962',
  '#addc30',
  '#fde725',
] as const;

const steps = 256;

const channels = (color: string): readonly number[] =>
  [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16));

/** The colour at a fraction of the ramp from the darkest to the lightest. */
export function colorAt(part: number): string {
  const place = Math.min(Math.max(part, 0), 1) * (stops.length - 1);
  const first = Math.min(Math.floor(place), stops.length - 2);
  const [a = [], b = []] = [stops[first], stops[first + 1]].map((stop) => channels(stop ?? ''));
  const mixed = a.map((from, i) => Math.round(from + ((b[i] ?? 0) - from) * (place - first)));
  return `#${mixed.map((channel) => channel.toString(16).padStart(2, '0')).join('')}`;
}

const inks = Uint32Array.from({ length: steps }, (_, i) => toPixel(colorAt(i / (steps - 1))));

/** The colour at a part of the ramp, as a pixel. */
export function inkAt(part: number): number {
  return inks[Math.round(Math.min(Math.max(part, 0), 1) * (steps - 1))] ?? 0;
}
