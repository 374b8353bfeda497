import { depthRange } from '../picture/layers.js';
import type { Area, Scene } from '../trace/header.js';
import { planeOf } from '../trace/plane.js';
import { around } from './plane.js';

/** A place in the scene: x and y as in the plane, y downward, and the depth z, toward the viewer. */
export type Spot = readonly [x: number, y: number, z: number];

/** How deep the box is, as a part of the area's longer side. */
export const depthOfBox = 0.6;
/** What is left before and behind all depths, as a part of what lies between. */
const margin = 0.08;
/** Depths that the box spans even if the scene is flat. */
const least = 0.25;

/**
 * The box that the scene in 3D stands in: the area, and along z the depths of the scene and those of its planes at the
 * corners of the area, but no more than once more the scene's own to either side. What is beyond is put at its end.
 */
export class Space {
  readonly area: Area;
  readonly far: number;
  readonly near: number;
  /** Pixels of the plane to a unit of depth. */
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

  /** Where something stands, from the middle of the box, in pixels of the plane. */
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
