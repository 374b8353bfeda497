import { methodRules, prefixed, variantTitles } from '../family-texts.js';
import type { FamilyTexts } from '../family-texts.js';
import { containment, point, short, signed } from '../words.js';

const lists = { surrounding: 'surrounding', outside: 'outside' } as const;
const found = { surrounding: 'surround', outside: 'lie outside' } as const;

const names = variantTitles('en');

export const family: FamilyTexts = {
  names,
  methods: prefixed('Warnock: ', names),
  rules: methodRules('en'),
  purposes: {
    Relation: 'how does the polygon lie relative to the window?',
    TrialFunction: 'does an edge of the polygon meet the window?',
    RayCrossings: 'how often does the outline cross a ray from the centre of the window?',
    OctantAngles: 'how far does the outline go round the window?',
    HidingPolygon: 'does a surrounding polygon lie before all others?',
  },
  panel: {
    level: 'level',
    third: 'Third',
    surrounding: 'Surrounding',
    outside: 'Outside',
    sinceLevel: (level) => `since level ${level}`,
    hides: 'hides all',
    ray: 'ray n',
    octants: 'octants S',
  },
  sentences: {
    back_face: ({ polygon, away }) =>
      away
        ? `${polygon} goes round clockwise: it looks away from the viewer and does not take part.`
        : `${polygon} goes round counter-clockwise: it looks towards the viewer and takes part.`,
    rejoin: ({ polygon, list, level }) =>
      `${polygon} was found to ${found[list]} a window of level ${level}, and this window is not part of that one: it goes back to the third list.`,
    join: ({ polygon, list, level }) =>
      `${polygon} joins the ${lists[list]} polygons at level ${level}: it is so for all parts of this window.`,
    relation: ({ polygon, relation }) =>
      ({
        outside: `${polygon} lies outside the window.`,
        inside: `${polygon} lies wholly inside the window.`,
        intersecting: `${polygon} intersects the window: an edge meets it.`,
        surrounding: `${polygon} surrounds the window.`,
      })[relation],
    trial: ({ polygon, edge, meets }) =>
      `Edge ${edge} of ${polygon} ${meets ? 'meets' : 'does not meet'} the window.`,
    meets: ({ polygon, meets }) =>
      meets
        ? `An edge of ${polygon} meets the window.`
        : `No edge of ${polygon} meets the window: it surrounds the window, or lies outside.`,
    ray: ({ at, edge, counts }, { after, header }) => {
      const so = `${containment(after.warnock)} so far`;
      if (at === 'CR4') {
        return counts === 1
          ? `Edge ${edge} crosses the ray: ${so}.`
          : `Edge ${edge} passes to the left of where the ray begins: ${so}.`;
      }
      if (counts > 0 && header.edition === 'vertex-counted-twice') {
        return `The beginning of edge ${edge} lies on the ray, which counts two here, touched or pierced: ${so}.`;
      }
      const where = `The beginning of edge ${edge} lies on the ray, where the outline`;
      if (counts === 2) return `${where} touches it, which counts two: ${so}.`;
      if (counts === 1) return `${where} pierces it, which counts one: ${so}.`;
      return `The beginning of edge ${edge} lies to the left of where the ray begins: ${so}.`;
    },
    crossings: ({ polygon, count }, words) =>
      `The outline of ${polygon} crosses the ray ${words.counted(count, { one: 'time', other: 'times' })}: ${count % 2 === 1 ? 'odd, so it surrounds the window' : 'even, so it lies outside'}.`,
    octants: ({ at, edge, from, to, difference }, { after }) => {
      const way = `Edge ${edge} goes from octant ${from} to octant ${to}`;
      const sum = signed(containment(after.warnock));
      return at === 'OA4'
        ? `${way}, the opposite one: split by a side of the window it turns by ${signed(difference)}; the sum is ${sum}.`
        : `${way}: ${signed(difference)}; the sum is ${sum}.`;
    },
    angle: ({ polygon, octants }) =>
      octants === 0
        ? `The turns of ${polygon} cancel: the sum is 0 octants, so it lies outside the window.`
        : `${polygon} goes round the window: the sum is ${signed(octants)} octants, so it surrounds the window.`,
    hiding: ({ polygon }) =>
      polygon === undefined
        ? 'No surrounding polygon is known to hide all others.'
        : `${polygon} surrounds the window and lies before all others: it hides them.`,
    split_vertex: ({ polygon, vertex, column, row, splits }) =>
      splits
        ? `Vertex ${vertex} of ${polygon} lies in the window, which is split next to it, at x = ${short(column)}, y = ${short(row)}.`
        : `Vertex ${vertex} of ${polygon} lies in the window, but next to it, at x = ${short(column)}, y = ${short(row)}, there is nothing to split.`,
    edge_depth: ({ polygon, edge, z }) =>
      `${polygon} is seen edge-on; its edge ${edge} has depth ${short(z)} at the point.`,
  },
  side: {
    TF2: (at, corner) => `The ${corner === null ? `point ${point(at)}` : `${corner} corner`}`,
    CR4: () => 'The centre of the window, where the ray begins,',
    OA4: (at, corner) =>
      `The ${corner === null ? `point ${point(at)}` : `${corner} corner`} of the window`,
    BF1: () => 'The vertex after it',
  },
};
