import { depthRange } from '../picture/layers.js';
import type { Area, Scene } from '../trace/header.js';
import { planeOf } from '../trace/polygon.js';
import { around } from './plane.js';

/** A place in the scene: x and y as in the plane, y downward, and the depth z, toward the viewer. */
export type Spot = readonly [x: number, y: number, z: number];

/** The depth of the box, as a share of the area's longer side. */
export const depthOfBox = 0.6;
/** The margin before and behind all depths, as a share of their range. */
const margin = 0.08;
/** The least range of depths, even if the scene is flat. */
const least = 0.25;

/**
 * The box of the 3D scene: the area, and along z the depths of the scene and of its planes at the corners of the area.
 * These planes extend the scene's own range at most by itself on either side. Anything beyond is put at the end of the box.
 */
export class Space {
  readonly area: Area;
  readonly far: number;
  readonly near: number;
  /** Pixels of the plane per unit of depth. */
  readonly scale: number;

  constructor(scene: Scene) {
    this.area = scene.area;
    const [from, to] = depthsIn(scene);
    const room = Math.max((to - from) * margin, (least - (to - from)) / 2);
    this.far = from - room;
    this.near = to + room;
    const { width, height } = this.area;
    this.scale = (Math.max(width, height) * depthOfBox) / (this.near - this.far);
  }

  get depths(): readonly [far: number, near: number] {
    return [this.far, this.near];
  }

  /** Width, height and depth, in pixels of the plane. */
  get size(): Spot {
    const { area, near, far, scale } = this;
    return [area.width, area.height, (near - far) * scale];
  }

  /** A place in the scene, relative to the middle of the box, in pixels of the plane. */
  place([x, y, z]: Spot): Spot {
    const { area, near, far, scale } = this;
    const depth = Math.min(Math.max(z, far), near);
    return [
      x - area.x - area.width / 2,
      y - area.y - area.height / 2,
      (depth - (near + far) / 2) * scale,
    ];
  }
}

function depthsIn(scene: Scene): readonly [number, number] {
  const { x, y, width, height } = scene.area;
  const [from, to] = scene.polygons.length > 0 ? depthRange(scene) : [0, 0];
  const deep = to - from;
  let [far, near] = [from, to];
  for (const polygon of scene.polygons) {
    const plane = planeOf(polygon);
    for (const corner of around([x, y, width, height])) {
      const z = plane(...corner);
      if (Number.isNaN(z)) continue;
      far = Math.max(Math.min(far, z), from - deep);
      near = Math.min(Math.max(near, z), to + deep);
    }
  }
  return [far, near];
}
