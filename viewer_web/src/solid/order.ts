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
