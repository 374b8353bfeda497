import type { SolidTexts } from '../solid-texts.js';

export const solid: SolidTexts = {
  solid: '3D',
  title: 'The scene in 3D',
  how: 'Drag or press arrow keys to turn, with Shift to move; wheel, + or − to zoom; 0 for all as at first.',
  turn: 'Seen from',
  views: { front: 'Front', side: 'Side', askew: 'Askew' },
  missing: 'This browser has no WebGL: of the polygons you see the outlines only.',
  depths: (far, near, part) =>
    `z grows toward you: ${far} to ${near} takes ${part} of the longer side.`,
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
