export const scene = {
  scene: 'Scene',
  edit: 'Edit',
  /** Replaces `how` where some vertices lie outside the picture. */
  howOutside:
    'Drag a vertex, or an edge to move the whole polygon. Some vertices lie outside the picture: zoom out to see them.',
  how: 'Drag a vertex to move it, or an edge to move the whole polygon. Keys move, raise, add and remove vertices: see “Keys”.',
  run: 'Run',
  method: 'method',
  kernel: 'numbers',
  edition: 'text',
  detail: 'detail',
  details: { windows: 'windows', polygons: 'polygons', signs: 'signs' },
  check: 'check every decision',
  undo: 'Undo',
  redo: 'Redo',
  draw: 'Draw a polygon',
  drawing:
    'Click the vertices. Click the first one again or press Enter to finish, Backspace to take back a vertex, Esc to cancel.',
  drawHere: 'Place for a vertex: arrow keys move it, Space sets it',
  clear: 'New',
  clearHint: 'Removes all polygons',
  save: 'Save',
  saveHint: 'Saves the scene as a file',
  link: 'Copy link',
  linkHint: 'Copies a link with the scene, this way to run it, and this step',
  linkCopied: 'Link copied.',
  linkTooLong:
    'This scene is too large for a link. “Save page” makes a file to send instead, which opens at this step.',
  page: 'Save page',
  pageHint: 'Saves this page as a file to send, with the run shown, this step and the bookmarks',
  pageSaved: 'Saved as a page that opens here. Send the file.',
  discard: {
    title: (name: string): string => `Discard the changes${name === '' ? '' : ` to “${name}”`}?`,
    text: 'You have changed the scene, and something else is about to take its place.',
    stay: 'Stay here',
    save: 'Save the scene and go on',
    discard: 'Discard',
  },
  area: 'Area',
  areaFields: { x: 'left', y: 'top', width: 'width', height: 'height' },
  background: 'background',
  polygons: 'Polygons',
  order: 'Where depths are equal, the first wins',
  colorOf: (id: string): string => `colour of ${id}`,
  nameOf: (id: string): string => `name of ${id}`,
  needsName: 'A polygon must have a name.',
  isTaken: (id: string): string => `Another polygon is named ${id}.`,
  cornersOf: (id: string): string => `vertices of ${id}`,
  earlier: (id: string): string => `${id} earlier`,
  later: (id: string): string => `${id} later`,
  remove: (id: string): string => `Remove ${id}`,
  corner: (id: string, n: number, x: number, y: number, z: number): string =>
    `${id}, vertex ${n}: x ${x}, y ${y}, depth ${z}`,
  coordinate: (axis: 'x' | 'y' | 'z', n: number): string => `${axis} of vertex ${n}`,
  depth: 'depth z',
  depthOf: (id: string): string => `depth of ${id}`,
  /** Shows the depth of each vertex. */
  tilt: 'Depth of each vertex',
  follows: 'Follows from the depths of the first three vertices',
  split: (n: number): string => `Add a vertex after vertex ${n}`,
  removeCorner: (n: number): string => `Remove vertex ${n}`,
  refused: (polygon: string | null, reason: string): string =>
    polygon === null ? reason : `${polygon}: ${reason}`,
  /** The reason for refusing a surface's formula. */
  formula: (reason: string): string => `The formula: ${reason}`,
  stands: 'Showing the previous run.',
  /** A place in the text of a file. */
  at: (line: number, column: number): string => `line ${line}, column ${column}`,
  missing: (key: string): string => `“${key}” is missing`,
  /** A place in a file: its kind in the library's words, and its number. */
  placeInFile: (kind: 'line' | 'face' | 'vertex', number: string): string => `${kind} ${number}`,
  /** What a scene lacks of a mesh, how often, and where first. */
  leftOut: (where: string, what: string, times: number): string =>
    `${where}: left out: ${what}${times > 1 ? ` (${times} times, here first)` : ''}`,
  /** The library's reasons for refusal that the page words differently. */
  reasons: {
    'colours: the library of materials "{}" cannot be read':
      'colours: the library of materials "{}" is missing; open it together with the mesh',
    'not a hexadecimal number such as "0x1.8p-3"':
      'not a number: write 2.5, or "0x1.8p-3" for a hexadecimal one',
    'has an edge that no other polygon shares':
      'has an edge that no other polygon shares: this method takes closed convex bodies',
    'goes along an edge in the same direction as another polygon':
      'goes along an edge in the same direction as another polygon: this method takes closed convex bodies',
  } as Readonly<Record<string, string>>,
  more: (n: number): string => `and ${n} more; the first are shown`,
};
