import type { Case } from '../time/course.js';

/** The dark dots of a square tile. They distinguish the cases where colours do not. */
interface Texture {
  readonly size: number;
  readonly dark: (x: number, y: number) => boolean;
}

export type TextureName = Case | 'plain' | 'striped';

/** CSS pixels: the least width at which stripes are visible. */
export const stripes = 6;

const textures: Readonly<Record<TextureName, Texture>> = {
  empty: { size: 4, dark: (x, y) => x === 1 && y === 1 },
  surrounded: { size: 1, dark: () => true },
  pixel: { size: 4, dark: (x, y) => x >> 1 === y >> 1 },
  single: { size: 6, dark: (x, y) => (x + y) % 6 < 4 },
  split: { size: 4, dark: (_x, y) => y !== 0 },
  plain: { size: 1, dark: () => true },
  striped: { size: stripes, dark: (x, y) => (x - y + stripes) % stripes < 4 },
};

/** The texture in a colour, with dark dots in full and the others pale, at `ratio` device pixels per CSS pixel. */
export function textureIn(name: TextureName, color: string, ratio: number): CanvasPattern | string {
  const { size, dark } = textures[name];
  if (size === 1) return color;
  const unit = Math.max(1, Math.round(ratio));
  const tile = document.createElement('canvas');
  tile.width = tile.height = size * unit;
  const context = tile.getContext('2d');
  if (context === null) return color;
  context.fillStyle = color;
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      context.globalAlpha = dark(x, y) ? 1 : 0.3;
      context.fillRect(x * unit, y * unit, unit, unit);
    }
  }
  return context.createPattern(tile, 'repeat') ?? color;
}
