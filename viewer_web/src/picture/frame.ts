import type { Area } from '../trace/header.js';
import type { Place } from './paint.js';
import type { Pixel } from './pixel.js';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** How the plane lies in a box of the page: the area and a margin around it, in the middle. */
export class Frame {
  /** What of the plane is shown. */
  readonly shown: readonly [number, number, number, number];
  /** CSS pixels per unit of the plane. */
  readonly scale: number;
  private readonly left: number;
  private readonly top: number;

  constructor(
    private readonly area: Area,
    readonly size: Size,
  ) {
    const { x, y, width, height } = area;
    const margin = Math.max(width, height) * 0.07;
    this.shown = [x - margin, y - margin, width + 2 * margin, height + 2 * margin];
    const fit = Math.min(size.width / this.shown[2], size.height / this.shown[3]);
    this.scale = Math.max(fit, 1e-6);
    this.left = (size.width - this.shown[2] * this.scale) / 2;
    this.top = (size.height - this.shown[3] * this.scale) / 2;
  }

  /** Where the area lies on a canvas with so many dots per CSS pixel. */
  place(ratio: number): Place {
    const { area, shown, scale } = this;
    return {
      x: Math.round((this.left + (area.x - shown[0]) * scale) * ratio),
      y: Math.round((this.top + (area.y - shown[1]) * scale) * ratio),
      width: Math.round(area.width * scale * ratio),
      height: Math.round(area.height * scale * ratio),
    };
  }

  /** What of the plane is under a point of the box. */
  at(x: number, y: number): readonly [x: number, y: number] {
    const { shown, scale } = this;
    return [shown[0] + (x - this.left) / scale, shown[1] + (y - this.top) / scale];
  }

  /** The pixel of the plane under a point of the box. */
  pixelAt(x: number, y: number): Pixel {
    const [across, down] = this.at(x, y);
    return [Math.floor(across), Math.floor(down)];
  }
}
