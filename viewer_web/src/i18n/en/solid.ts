export const solid = {
  solid: '3D',
  title: 'The scene in 3D',
  how: 'Drag or press the arrow keys to turn, with Shift to move; wheel, + or − to zoom; 0 to reset. The camera is orthographic.',
  turn: 'Seen from',
  views: { front: 'Front', side: 'Side', askew: 'Axonometric' },
  missing: 'This browser has no WebGL: you see only the outlines of the polygons.',
  depths: (far: string, near: string): string =>
    `Larger z is nearer: ${far} to ${near}. The depth axis is not to scale.`,
  window: (window: string): string => `Window ${window}: the column along z.`,
  corners: (depths: string): string => `Nearest so far at its corners: ${depths}.`,
  plane: (polygon: string, depths: string): string => `On the plane of ${polygon}: ${depths}.`,
  clip: 'Dashed: the clipped polygon so far.',
  point: (point: string, depths: string): string => `On the line through ${point}: ${depths}.`,
  noPolygon: 'no polygon',
  scanline: (row: string, edges: string): string =>
    `Row ${row}: the plane along z. Active edges: ${edges}.`,
  span: (from: string, to: string): string => `Line (x, z): from ${from} to ${to}.`,
  pixel: (pixel: string, own: string, stored: string): string =>
    `Pixel ${pixel}: depth ${own}, stored ${stored}.`,
};
