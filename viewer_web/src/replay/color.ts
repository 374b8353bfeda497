/** A colour `#rrggbb` as the four bytes of a canvas pixel. */
export function toPixel(color: string): number {
  const rgb = Number.parseInt(color.slice(1), 16);
  return (0xff000000 | ((rgb & 0xff) << 16) | (rgb & 0xff00) | (rgb >> 16)) >>> 0;
}

/** An unpainted pixel has the background colour with alpha 0. */
export const isPainted = (pixel: number): boolean => pixel >>> 24 !== 0;

export function toColor(pixel: number): string {
  const rgb = ((pixel & 0xff) << 16) | (pixel & 0xff00) | ((pixel >> 16) & 0xff);
  return `#${rgb.toString(16).padStart(6, '0')}`;
}
