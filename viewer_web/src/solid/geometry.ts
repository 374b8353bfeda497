import { BufferGeometry, Color, Float32BufferAttribute } from 'three';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Face, Line } from './drawing.js';

/** The drawing order: all faces, hidden lines, and visible lines on their casings. */
export const order = {
  wall: 0,
  behind: 1,
  depth: 2,
  front: 3,
  glass: 4,
  hidden: 5,
  casing: 6,
  line: 7,
} as const;

/** The colour of faces without a colour of their own. */
const glass = '#7c8798';

/** Convex faces as triangles, each in its colour. */
export function facesOf(faces: readonly Face[]): BufferGeometry {
  const positions: number[] = [];
  const colors: number[] = [];
  for (const { points, color = glass } of faces) {
    const rgb = new Color(color).toArray();
    const [first, ...others] = points;
    others.forEach((second, i) => {
      const third = others[i + 1];
      if (first === undefined || third === undefined) return;
      positions.push(...first, ...second, ...third);
      colors.push(...rgb, ...rgb, ...rgb);
    });
  }
  return new BufferGeometry()
    .setAttribute('position', new Float32BufferAttribute(positions, 3))
    .setAttribute('color', new Float32BufferAttribute(colors, 3));
}

/** Lines as segments, each in its colour or else in that of its look. */
export function segmentsOf(lines: readonly Line[], look: string): LineSegmentsGeometry {
  const positions: number[] = [];
  const colors: number[] = [];
  for (const { points, closed, color = look } of lines) {
    const rgb = new Color(color).toArray();
    points.forEach((to, i) => {
      const from = i > 0 || closed ? points.at(i - 1) : undefined;
      if (from === undefined) return;
      positions.push(...from, ...to);
      colors.push(...rgb, ...rgb);
    });
  }
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(positions).setColors(colors);
  return geometry;
}
