/** In which order things are drawn over one another: all faces, what is hidden of lines, and lines on their casings. */
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
