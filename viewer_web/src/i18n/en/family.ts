import { prefixed } from '../../language/family-texts.js';
import type { FamilyTexts } from '../../language/family-texts.js';

const names = {
  'warnock-simplest': 'simplest',
  'warnock-full': 'three lists',
  'warnock-angles': 'sum of angles',
  'warnock-vertex': 'split at a vertex',
  'warnock-edges': 'edge-on polygons',
  'warnock-bodies': 'closed bodies',
} as const;

export const family: FamilyTexts = {
  names,
  methods: prefixed('Warnock: ', names),
  rules: {
    warnock: 'Convex planar polygons. Looks at a window; paints it if it is plain, else splits it.',
    'warnock-simplest':
      'Convex planar polygons. Splits every window that is not empty by the polygons’ boxes, down to the pixels.',
    'warnock-full': 'Convex planar polygons. Keeps three lists; containment by crossings of a ray.',
    'warnock-angles':
      'Convex planar polygons. Keeps three lists; containment by the sum of angles in octants.',
    'warnock-vertex':
      'Convex planar polygons. Keeps three lists; splits a window at a vertex in it.',
    'warnock-edges':
      'Convex planar polygons. Keeps three lists; a polygon seen edge-on shows as a segment, at its nearest depth.',
    'warnock-bodies':
      'Closed convex bodies, each polygon counter-clockwise as seen from outside. Faces that look away are left out; of equally near ones the face that looks towards the viewer shows.',
    'floating-horizon':
      'Curves with samples on whole columns, the nearest first. Draws what is beyond both horizons, and raises them to it.',
    'weiler-atherton':
      'Convex planar polygons. Cuts them by one another’s outlines until what is visible is known as regions; then paints these.',
    zbuffer:
      'Convex planar polygons. Scans each with an active edge list; keeps the nearest depth at each pixel.',
  },
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
};
