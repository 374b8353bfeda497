import { algorithmOf } from '../algorithm/algorithm.js';
import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import type { Numbers } from '../language/texts.js';
import type { Polygon } from '../trace/header.js';
import type { Question } from './question.js';

/** A named fact at a step. */
export type Fact = readonly [name: string, said: string];

/** The vertices in full, for calculations. */
const vertices = (polygon: Polygon | undefined, { list, inFull }: Numbers): string =>
  (polygon?.vertices ?? []).map((vertex) => `(${list(vertex, inFull)})`).join(' ');

/** The polygons that a question is about. */
const idsOf = (view: View, { about }: Question): readonly string[] => [
  ...algorithmOf(view.header).polygonsAsked(view, 'polygon' in about ? about.polygon : null),
  ...('other' in about ? [about.other] : []),
];

function polygonFacts(view: View, question: Question): readonly Fact[] {
  const { header, texts: page, language } = view;
  return idsOf(view, question).map((id) => [
    page.things.polygon(id),
    vertices(header.scene.byId.get(id), texts[language].numbers),
  ]);
}

/** The facts needed to answer a question at its step, besides its text and options. */
export function factsOf(view: View, question: Question): readonly Fact[] {
  const { area } = view.header.scene;
  const { predict, numbers } = texts[view.language];
  return [
    [predict.area, numbers.windowText([area.x, area.y, area.width, area.height])],
    ...algorithmOf(view.header).facts(view),
    ...polygonFacts(view, question),
  ];
}
