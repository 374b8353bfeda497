/** The parts of the panels of state, which a lesson may ask for by name. Each algorithm has some of them. */
export const stateParts = [
  'window',
  'corner-depths',
  'active-polygons',
  'stack',
  'scanline',
  'active-edges',
  'z-buffer',
  'list',
  'parts',
  'visible',
  'curve',
  'side-edges',
  'horizons',
] as const;
export type StatePart = (typeof stateParts)[number];
