import {
  DataTexture,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
} from 'three';
import type { Pixels } from '../replay/screen.js';
import { order } from './geometry.js';
import type { Space } from './space.js';

/** The largest side in pixels for which every pixel has a texel. */
const most = 1024;

/** The picture so far, at the far end of the box; unpainted pixels are transparent. */
export class Wall {
  readonly mesh = new Mesh(
    new PlaneGeometry(),
    new MeshBasicMaterial({ side: DoubleSide, transparent: true, depthWrite: false }),
  );
  private texture: DataTexture | null = null;

  constructor() {
    this.mesh.renderOrder = order.wall;
  }

  fit({ size: [width, height, depth] }: Space): void {
    this.mesh.scale.set(width, height, 1);
    this.mesh.position.z = -depth / 2;
  }

  show(picture: Pixels): void {
    const step = Math.ceil(Math.max(picture.width, picture.height) / most);
    const texture = this.sized(Math.ceil(picture.width / step), Math.ceil(picture.height / step));
    const { data, width, height } = texture.image;
    if (!(data instanceof Uint8Array)) return;
    const texels = new Uint32Array(data.buffer);
    for (let j = 0; j < height; j++) {
      const row = picture.row(j * step);
      for (let i = 0; i < width; i++) texels[j * width + i] = row[i * step] ?? 0;
    }
    texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture?.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  private sized(width: number, height: number): DataTexture {
    const old = this.texture;
    if (old?.image.width === width && old.image.height === height) return old;
    old?.dispose();
    const texture = new DataTexture(new Uint8Array(4 * width * height), width, height);
    texture.colorSpace = SRGBColorSpace;
    this.texture = texture;
    this.mesh.material.map = texture;
    this.mesh.material.needsUpdate = true;
    return texture;
  }
}
