import type { Abouts } from '../../predict/question.js';
import { inFull, point, short, windowText } from '../../language/words.js';
import { places } from './page.js';

const sides = ['top', 'left', 'bottom', 'right'];

export const predict = {
  title: 'Predict',
  /** Includes the key if single-character keys are on. */
  hint: (key: string | null): string =>
    `Say what the procedure will do next, and why, before it does it.${key === null ? '' : ` Press ${key} for a question.`}`,
  next: 'Next question',
  none: 'No more questions of these kinds from here on.',
  forced: 'Stop and ask',
  forcedHint: 'The run goes on only when the question is answered, if only by “I don’t know”.',
  askAbout: 'Ask about',
  kinds: {
    plane: 'the plane of a polygon',
    facing: 'back faces',
    split: 'the split at a vertex',
    trial: 'an edge that meets the window',
    depth: 'the depth at a point',
    edgeDepth: 'the depth of an edge-on polygon',
    fill: 'the pixels of an outline',
    window: 'the case of a window',
    pop: 'the next window',
    relation: 'the relation to a window',
    ray: 'crossings of the ray',
    octants: 'the sum of angles',
    corners: 'depths at the corners',
    inside: 'the surround test',
    point: 'what is seen at a point',
    clip: 'clipping by a side',
    ael: 'the active edge list',
    pixels: 'pixels of a row',
    flags: 'flags of columns',
    horizons: 'the new horizons',
    sideEdge: 'the side of the surface',
    meeting: 'where a horizon is met',
    piercing: 'what pierces',
    sort: 'the depth sort',
    parted: 'inside and outside',
    entering: 'entering and leaving',
    walk: 'the walk along outlines',
    behind: 'what is behind',
    stack: 'the next list',
    painted: 'the nearer of two regions',
  },
  intro: {
    plane: ({ polygon, c }: Abouts['plane']): string =>
      `InitializePolygon: the plane a x + b y + c z + d = 0 of ${polygon}. Its c is ${short(c)}.`,
    facing: (): string => 'BackFaces: a face that looks away from the viewer does not take part.',
    split: ({ polygon, vertex, window }: Abouts['split']): string =>
      `VertexSplit: vertex ${vertex + 1} of ${polygon} lies in the window ${windowText(window)}. The window is split at the pixel boundaries nearest to the vertex, provided that one of them is inside. If two boundaries are equally near, the lesser is taken.`,
    trial: ({ polygon, edge, window }: Abouts['trial']): string =>
      `TrialFunction: ${polygon} and the window ${windowText(window)}. f is positive to the right of an edge, as one walks along it, and negative to the left; edge ${edge} is the first. An edge that only touches the window does not meet it.`,
    depth: ({ polygon, point: at, plane }: Abouts['depth']): string =>
      `Depth: ${polygon} at ${point(at)}. In its plane a x + b y + c z + d = 0, a, b, c and d are ${plane.map(inFull).join('; ')}.`,
    edgeDepth: ({ polygon, point: at }: Abouts['edgeDepth']): string =>
      `EdgeDepth: ${polygon} is edge-on, and ${point(at)} lies on its line. The greatest depth of its edges there counts.`,
    fill: ({ row, outline }: Abouts['fill']): string =>
      `FillPolygon: row ${row} of the outline ${outline.map(point).join(' ')}. A pixel is covered if its centre lies between the ends of the row or on one.`,
    window: ({ window, by }: Abouts['window']): string => {
      const examined = `The window ${windowText(window)} is examined.`;
      if (by === null) return examined;
      const sees =
        by === 'ProcessWindow' ? `${by} sets hasSurround for a polygon` : `${by} finds a polygon`;
      return `${examined} ${sees} only if it surrounds the window and the plane of no other is nearer at the four corners, not even where that other does not reach. Beside each polygon are the depths of its plane at the upper corners, left and right, and then at the lower ones.`;
    },
    pop: ({ divided }: Abouts['pop']): string =>
      `The window ${windowText(divided)} was split, and its parts were pushed.`,
    relation: ({ polygon, window }: Abouts['relation']): string =>
      `Relation: ${polygon} and the window ${windowText(window)}. An edge that only touches the window does not meet it.`,
    ray: ({ polygon, window }: Abouts['ray']): string =>
      `RayCrossings: ${polygon} and the ray from the centre of the window ${windowText(window)} to the right. A vertex on the ray counts with the edge that leaves the ray there: once if the outline passes to the other side, twice if it returns to the same side.`,
    octants: ({ polygon, window }: Abouts['octants']): string =>
      `OctantAngles: ${polygon} about the window ${windowText(window)}. The octants are numbered clockwise; the upper left one is 0. A point on the line of a side lies beyond it, and clockwise turns are positive.`,
    corners: ({ polygon }: Abouts['corners']): string =>
      `The depths of ${polygon} at the corners are known; beside each is the nearest so far. An equal depth is not nearer.`,
    inside: ({ polygon, point: at, corner }: Abouts['inside']): string =>
      `SurroundTest: the ${corner === null ? 'point' : `${places[corner]} corner`} ${point(at)} and ${polygon}. f is positive to the right of an edge, as one walks along it. A point on the outline counts as inside. Two opposite signs end the test.`,
    point: ({ point: at }: Abouts['point']): string =>
      `PointColor: ${point(at)}, the centre of the window. A polygon covers the points of its outline, too; the first of equally near ones counts.`,
    clip: ({ polygon, side }: Abouts['clip']): string =>
      `PolygonClip: ${polygon} and side ${side} of 4, the ${sides[side - 1] ?? ''} one. It clips by the whole line of the side. A vertex on that line stays and is no crossing.`,
    ael: ({ polygon, row }: Abouts['ael']): string =>
      row === null
        ? `What is the AEL of ${polygon} on its first scanline?`
        : `Row ${row} of ${polygon} is done. What is the AEL on the next scanline?`,
    piercing: ({ polygons }: Abouts['piercing']): string =>
      `SplitPiercing: ${polygons.join(', ')}. Those that pierce each other are split along the line in which their planes meet.`,
    sort: ({ pieces }: Abouts['sort']): string =>
      `DepthSort: ${pieces} pieces, by the greatest depth that each has at its vertices. Those of equal depth stay in their order.`,
    parted: ({ clip, pieces }: Abouts['parted']): string =>
      `${clip} is the clip polygon of a list of ${pieces} pieces. The others are clipped by its outline.`,
    entering: ({ polygon, clip }: Abouts['entering']): string =>
      `RegionClip: the outline of ${polygon} and the clip polygon ${clip}. The points are those of the outline, in the order in which one walks along it.`,
    walk: ({ polygon, clip, from }: Abouts['walk']): string =>
      `RegionClip: walk round the part of ${polygon} inside ${clip}, from point ${from}, where the outline of ${polygon} enters. The points of that outline come first, then the other vertices of ${clip}, each in the order of the walk.`,
    behind: ({ clip }: Abouts['behind']): string =>
      `RemoveBehind: the parts inside ${clip}. Depth is compared at the mean of a part’s vertices; of equal depths the first polygon of the scene is in front.`,
    stack: ({ clip, nearer }: Abouts['stack']): string =>
      `${nearer.length === 0 ? `Nothing inside ${clip} is nearer than ${clip}.` : `Nearer than ${clip} inside its outline: ${nearer.join(', ')}.`} Which list comes off the stack next?`,
    pixels: ({ polygon, row }: Abouts['pixels']): string =>
      `ShowLine: ${polygon} on row ${row}, where something is drawn already. Beside each depth is the stored one. An equal depth is not painted.`,
    flags: ({ curve }: Abouts['flags']): string =>
      `Visibility: curve ${curve} over the next columns. Beside each column are the y-coordinate of the curve and the horizons; y grows downward.`,
    sideEdge: ({ curve, from, to }: Abouts['sideEdge']): string =>
      `SideEdge: from ${point(from)} to ${point(to)}, the end of curve ${curve}. Beside each column between are the horizons; y grows downward.`,
    painted: ({ polygon, other, point: at }: Abouts['painted']): string =>
      `PaintRegions: the centre ${point(at)} belongs to regions of ${polygon} and ${other}. z is the depth of ${polygon} there, z′ that of ${other}.`,
    horizons: ({ curve }: Abouts['horizons']): string =>
      `Horizon: a segment of curve ${curve} over two columns. Beside each column are the y-coordinate of the segment and the horizons; y grows downward.`,
    meeting: ({ curve }: Abouts['meeting']): string =>
      `Intersection: a segment of curve ${curve} between two columns. Beside each column are the y-coordinate of the segment and the horizons; y grows downward.`,
  },
  asks: {
    plane: 'What are the others?',
    away: 'Which of these faces look away?',
    boundaries: 'Which boundaries are these?',
    splits: 'Is the window split there?',
    cornerSigns: 'What is the sign of f for this edge at each corner of the window?',
    meetsFirst: 'Which edge is the first to meet the window?',
    z: 'What is the depth?',
    bothDepths: 'What are the depths?',
    nearerThere: 'z against z′:',
    spanning: 'Which edges have the point between their ends, or at one?',
    covered: 'Which of these pixels are covered?',
    popped: 'Which window is popped next?',
    waiting: 'How many windows then wait on the stack?',
    case: 'Which case does Warnock’s algorithm take?',
    stay: 'Which polygons stay in the window’s list? Only their boxes are tested.',
    hides: 'Which polygon is found to hide all others in this window?',
    nearer: 'At which corners is the polygon nearer?',
    cornerDepths: 'The polygon’s depth at this corner against the nearest so far:',
    inside: 'Does the point lie in the polygon?',
    signs: 'Which signs are found, edge by edge, until the answer is known?',
    covers: 'Which polygons cover the point, by SurroundTest?',
    wins: 'Which polygon does PointColor find?',
    depth: 'Which depth decides?',
    cut: 'Which edges cross the line of this side?',
    list: 'Which vertices does the new list have, in order?',
    leave: 'Which edges leave the list?',
    enter: 'Which edges enter the list?',
    order: 'Which edges does the list then have, from left to right?',
    entries: 'What do the list’s entries hold then, from left to right?',
    shown: 'In which of these columns does ShowLine paint the polygon?',
    lies: 'What does Relation return?',
    test: 'Which line decides?',
    crossed: 'Which edges are counted?',
    crossings: 'How many crossings are there in all?',
    halved: 'Which edges go to the opposite octant and must be split?',
    pierced: 'Which polygons does SplitPiercing split?',
    pieces: 'How many pieces are there now in all?',
    first: 'A piece of which polygon is the first?',
    within: 'Which of the others have a part inside the clip polygon?',
    beyond: 'Which of the others have a part outside the clip polygon?',
    outlines: 'How many outlines does the polygon’s outside part have? Count holes, too.',
    enters: 'Where does the outline enter the clip polygon?',
    leaves: 'Where does the outline leave the clip polygon?',
    walked: 'Which points follow, until the walk is back where it began?',
    hidden: 'Parts of which polygons are behind?',
    partDepth: 'The depth of this part at its mean against that of the clip polygon:',
    next: 'And then?',
    clips: 'Which polygon is the clip polygon then?',
    listed: 'Pieces of which polygons are in the list?',
    sum: 'What is the sum, in octants?',
    pixelDepths: 'The polygon’s depth in this column against the stored one:',
    above: 'Over which of these columns is the curve on the upper horizon or above it?',
    below: 'Over which of these columns is the curve on the lower horizon or below it?',
    raised: 'Over which of these columns does the upper horizon rise?',
    lowered: 'Over which of these columns does the lower horizon fall?',
    meets: 'Which horizon does the segment meet?',
    where: 'Where do the two meet?',
  },
  /** The format of an answer of several values. */
  rows: {
    cornerSigns: 'one sign per corner, such as + 0 − −',
    signs: 'one sign per edge, such as + 0 −',
    list: 'numbers of vertices that stay, x for a crossing, such as 2 x x; − for none',
    order: 'numbers of edges, such as 3 1; − for none',
    walked: 'numbers of points, such as 4 5 9',
  },
  /** A table of numbers: the names of its rows, from 1, and of its columns, and how to write a number. */
  table: {
    entry: (number: number): string => `entry ${number}`,
    columns: {
      a: 'a',
      b: 'b',
      d: 'd',
      column: 'column',
      row: 'row',
      z: 'z',
      otherZ: 'z′',
      x: 'x',
      until: 'last row',
    },
    hint: 'numbers such as 7.75 or 31/4; three decimals are enough',
  },
  /** The text in the places after the end of a row. */
  ends: {
    signs: 'no longer needed',
    cornerSigns: 'no more',
    list: 'no more',
    order: 'no more',
    walked: 'no more',
  },
  crossing: 'a crossing',
  area: 'Area',
  noPolygon: { hides: 'none is found', wins: 'the background' },
  relations: { '>': 'greater', '=': 'equal', '<': 'less' },
  lies: {
    outside: 'outside',
    inside: 'inside',
    intersecting: 'intersecting',
    surrounding: 'surrounding',
  },
  /** The conditions that the lines of the relation test examine. */
  tests: {
    RE1: 'the box lies outside',
    RE2: 'the box lies strictly inside',
    RE3: 'an edge meets the window',
    RE4: 'containment',
  },
  becomes: {
    visible: 'the clip polygon is visible',
    again: 'what is nearer goes on the stack, the clip polygon last',
  },
  edge: (edge: string): string => `edge ${edge}`,
  column: (column: string): string => `column ${column}`,
  horizons: { upper: 'the upper one', lower: 'the lower one' },
  between: 'between the columns',
  overColumn: (column: string): string => `over column ${column}`,
  inPicture: 'You can also choose in the picture.',
  hintFor: 'Hint',
  /** With the share of a point that it costs. */
  hintCosts: (cost: string): string => `Costs ${cost} of this part’s point`,
  hinted: {
    one: (entry: string): string => `Hint: “${entry}” is wrong.`,
    some: (entry: string): string => `Hint: ${entry} was wrong and is corrected.`,
    row: (entry: string): string => `Hint: the start is right; its last entry is ${entry}.`,
    table: (entry: string): string => `Hint: ${entry}.`,
  },
  hintedNothing: 'Hint: nothing to correct.',
  firstWrong: (entry: string): string => `First wrong entry: ${entry}.`,
  tooLong: 'the row is too long',
  points: (points: string, most: number): string => `${points} of ${most} points`,
  check: 'Check',
  giveUp: 'I don’t know',
  again: 'Try again',
  missing: 'Answer each part first.',
  verdicts: { right: 'Right.', some: 'Not quite.', wrong: 'Wrong.', givenUp: 'Not answered.' },
  partRight: 'right',
  partWrong: 'wrong',
  rightIs: (answer: string): string => `Correct: ${answer}`,
  empty: 'none',
  because: 'Why',
  waits: (step: number): string => `A question waits at step ${step}`,
  score: 'Score',
  counted: (right: number, asked: number): string => `${right} of ${asked} right on the first try`,
  first: 'Only the first answer counts.',
  earlier: (answers: number): string => `Answers from earlier visits: ${answers}.`,
  /** With the percentage in the course, and how many questions are left before the lesson is completed. */
  kept: (percent: string, left: number): string =>
    `Your score in the course: ${percent} of 100. ${left === 0 ? 'The lesson is completed.' : `Questions left to answer: ${left}.`}`,
  notKept: 'The course did not accept the score. Save it as a file.',
  name: 'Your name, if you like',
  save: 'Save the score',
  saveHint: 'Saves questions and answers as a file; nothing is sent anywhere',
  moodle: 'Questions as Moodle XML',
  moodleHint:
    'Saves questions from the whole run, with pictures and answers, for the question bank of Moodle',
  moodleNone: 'This run has nothing to ask about: it is too short, or its trace is too coarse.',
};
