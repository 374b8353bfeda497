import type { PredictTexts } from '../../language/predict-texts.js';
import { point, windowText } from '../../language/words.js';
import { places } from './page.js';

const sides = ['top', 'left', 'bottom', 'right'];

export const predict: PredictTexts = {
  title: 'Predict',
  hint: (key) =>
    `Say what the procedure will do next, and why, before it does it.${key === null ? '' : ` Press ${key} for a question.`}`,
  next: 'Next question',
  none: 'No more questions of these kinds from here on.',
  forced: 'Stop and ask',
  forcedHint: 'The run goes on only when the question is answered or given up.',
  askAbout: 'Ask about',
  kinds: {
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
    meeting: 'where a horizon is met',
    piercing: 'what pierces',
    sort: 'the depth sort',
    parted: 'inside and outside',
    entering: 'entering and leaving',
    walk: 'the walk along outlines',
    behind: 'what is behind',
    stack: 'the next list',
  },
  intro: {
    window: ({ window }) => `What becomes of the window ${windowText(window)}?`,
    pop: ({ divided }) => `The window ${windowText(divided)} was split, and its parts were pushed.`,
    relation: ({ polygon, window }) =>
      `How does ${polygon} lie relative to the window ${windowText(window)}?`,
    ray: ({ polygon, window }) =>
      `RayCrossings: ${polygon} and the ray from the centre of the window ${windowText(window)} to the right.`,
    octants: ({ polygon, window }) =>
      `OctantAngles: ${polygon} about the window ${windowText(window)}. The octants are numbered clockwise; the upper left one is 0.`,
    corners: ({ polygon }) =>
      `The depths of ${polygon} at the corners are known; beside each is the nearest so far.`,
    inside: ({ polygon, point: at, corner }) =>
      `SurroundTest: the ${corner === null ? 'point' : `${places[corner]} corner`} ${point(at)} and ${polygon}.`,
    point: ({ point: at }) => `What is seen at ${point(at)}, the centre of the window?`,
    clip: ({ polygon, side }) =>
      `PolygonClip: ${polygon} and side ${side} of 4, the ${sides[side - 1] ?? ''} one.`,
    ael: ({ polygon, row }) =>
      row === null
        ? `What is the AEL of ${polygon} on its first scanline?`
        : `Row ${row} of ${polygon} is done. What is the AEL on the next scanline?`,
    piercing: ({ polygons }) =>
      `SplitPiercing: ${polygons.join(', ')}. Those that pierce each other are split along the line in which their planes meet.`,
    sort: ({ pieces }) =>
      `DepthSort: ${pieces} pieces, by the greatest depth that each has at its vertices. Those of equal depth stay in their order.`,
    parted: ({ clip, pieces }) =>
      `${clip} is the clip polygon of a list of ${pieces} pieces. The others are clipped by its outline.`,
    entering: ({ polygon, clip }) =>
      `RegionClip: the outline of ${polygon} and the clip polygon ${clip}. The points are those of the outline, in the order in which one walks along it.`,
    walk: ({ polygon, clip, from }) =>
      `RegionClip: walk round the part of ${polygon} inside ${clip}, from point ${from}, where the outline of ${polygon} enters. The points of that outline come first, then the other vertices of ${clip}, each in the order of the walk.`,
    behind: ({ clip }) =>
      `RemoveBehind: the parts inside ${clip}. Depth is compared at the mean of a part’s vertices.`,
    stack: ({ clip, nearer }) =>
      `${nearer.length === 0 ? `Nothing inside ${clip} is nearer than ${clip}.` : `Nearer than ${clip} inside its outline: ${nearer.join(', ')}.`} Which list comes off the stack next?`,
    pixels: ({ polygon, row }) =>
      `ShowLine: ${polygon} on row ${row}, where something is drawn already. Beside each depth is the stored one.`,
    flags: ({ curve }) =>
      `Visibility: curve ${curve} over the next columns. Beside each are its height, which grows downward, and the horizons.`,
    horizons: ({ curve }) =>
      `Horizon: a segment of curve ${curve} over two columns. Beside each are its height, which grows downward, and the horizons.`,
    meeting: ({ curve }) =>
      `Intersection: a segment of curve ${curve} between two columns. Beside each are its height, which grows downward, and the horizons.`,
  },
  asks: {
    popped: 'Which window is popped next?',
    case: 'Which case is it?',
    stay: 'Which polygons stay in its list?',
    hides: 'Which one hides all others in it?',
    nearer: 'At which corners is it nearer?',
    cornerDepths: 'Its depth there against the nearest so far:',
    inside: 'Does the point lie in it?',
    signs: 'Which signs are found, edge by edge, until the answer is known?',
    covers: 'Which polygons cover the point?',
    wins: 'Which one is seen?',
    depth: 'Which depth decides?',
    cut: 'Which edges cross this side?',
    list: 'Which vertices does the new list have, in order?',
    leave: 'Which edges leave the list?',
    enter: 'Which edges enter it?',
    order: 'Which edges does it then have, from left to right?',
    shown: 'At which of these columns is it seen?',
    lies: 'How does it lie?',
    test: 'Which line decides?',
    crossed: 'Which edges are counted?',
    crossings: 'How many crossings are there in all?',
    halved: 'Which edges go to the opposite octant and must be split?',
    pierced: 'Which polygons are split?',
    pieces: 'How many pieces are there now in all?',
    first: 'A piece of which polygon is the first?',
    within: 'Which of them have a part inside?',
    beyond: 'Which have a part outside?',
    outlines: 'How many outlines does its outside part have? Count holes, too.',
    enters: 'Where does it enter the clip polygon?',
    leaves: 'Where does it leave it?',
    walked: 'Which points follow, until the walk is back where it began?',
    hidden: 'Which of them are behind?',
    partDepth: 'Its depth there against that of the clip polygon:',
    next: 'And then?',
    clips: 'Which polygon is the clip polygon then?',
    listed: 'Pieces of which polygons are in the list?',
    sum: 'What is the sum, in octants?',
    pixelDepths: 'Its depth there against the stored one:',
    above: 'Over which of these columns is it on the upper horizon or above it?',
    below: 'Over which is it on the lower horizon or below it?',
    raised: 'Over which of these columns does the upper horizon rise?',
    lowered: 'Over which does the lower horizon fall?',
    meets: 'Which horizon does it meet?',
    where: 'Where?',
  },
  rows: {
    signs: 'one sign per edge, such as + 0 −',
    list: 'numbers of vertices that stay, x for a crossing, such as 2 x x; − for none',
    order: 'numbers of edges, such as 3 1; − for none',
    walked: 'numbers of points, such as 4 5 9',
  },
  ends: { signs: 'no longer needed', list: 'no more', order: 'no more', walked: 'no more' },
  crossing: 'a crossing',
  area: 'Area',
  noPolygon: { hides: 'none', wins: 'the background' },
  relations: { '>': 'greater', '=': 'equal', '<': 'less' },
  lies: {
    outside: 'outside',
    inside: 'inside',
    intersecting: 'intersecting',
    surrounding: 'surrounding',
  },
  tests: {
    RE1: 'the box lies outside',
    RE2: 'the box lies inside',
    RE3: 'an edge meets the window',
    RE4: 'containment',
  },
  becomes: {
    visible: 'the clip polygon is visible',
    again: 'what is nearer goes on the stack, the clip polygon last',
  },
  edge: (edge) => `edge ${edge}`,
  column: (column) => `column ${column}`,
  horizons: { upper: 'the upper one', lower: 'the lower one' },
  between: 'between the columns',
  overColumn: (column) => `over column ${column}`,
  inPicture: 'You can also choose in the picture.',
  hintFor: 'Hint',
  hintCosts: (cost) => `Costs ${cost} of the point for this part`,
  hinted: {
    one: (entry) => `Hint: not ${entry}.`,
    some: (entry) => `Hint: ${entry} was wrong and is corrected.`,
    row: (entry) => `Hint: right up to ${entry}.`,
  },
  hintedNothing: 'Hint: nothing to correct.',
  firstWrong: (entry) => `First wrong entry: ${entry}.`,
  tooLong: 'the row is too long',
  points: (points, most) => `${points} of ${most} points`,
  check: 'Check',
  giveUp: 'Give up',
  again: 'Try again',
  missing: 'Answer each part first.',
  verdicts: { right: 'Right.', wrong: 'Not quite.', givenUp: 'Given up.' },
  partRight: 'right',
  partWrong: 'wrong',
  rightIs: (answer) => `Correct: ${answer}`,
  empty: 'none',
  because: 'Why',
  waits: (step) => `A question waits at step ${step}`,
  score: 'Score',
  counted: (right, asked) => `${right} of ${asked} right at the first answer`,
  first: 'Only the first answer counts.',
  earlier: (answers) => `Answers from earlier visits: ${answers}.`,
  kept: (percent, left) =>
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
