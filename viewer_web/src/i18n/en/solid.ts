import type { SolidTexts } from '../../language/solid-texts.js';

export const solid: SolidTexts = {
  solid: '3D',
  title: 'The scene in 3D',
  how: 'Drag or press the arrow keys to turn, with Shift to move; wheel, + or − to zoom; 0 to reset. The camera is orthographic.',
  turn: 'Seen from',
  views: { front: 'Front', side: 'Side', askew: 'Axonometric' },
  missing: 'This browser has no WebGL: you see only the outlines of the polygons.',
  depths: (far, near) => `Larger z is nearer: ${far} to ${near}. The depth axis is not to scale.`,
  window: (window) => `Window ${window}: the column along z.`,
  corners: (depths) => `Nearest so far at its corners: ${depths}.`,
  plane: (polygon, depths) => `On the plane of ${polygon}: ${depths}.`,
  clip: 'Dashed: the clipped polygon so far.',
  point: (point, depths) => `On the line through ${point}: ${depths}.`,
  noPolygon: 'no polygon',
  scanline: (row, edges) => `Row ${row}: the plane along z. Active edges: ${edges}.`,
  span: (from, to) => `Line (x, z): from ${from} to ${to}.`,
  pixel: (pixel, own, stored) => `Pixel ${pixel}: depth ${own}, stored ${stored}.`,
};
