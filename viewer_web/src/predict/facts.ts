import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { Numbers } from '../language/texts.js';
import type { Piece } from '../weiler-atherton/events.js';
import type { Regions } from '../weiler-atherton/state.js';
import type { Joined, Warnock } from '../warnock/state.js';
import { hasThreeLists } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { View } from '../algorithm/view.js';
import { mostOptions } from './asker.js';
import { ownersOf } from '../weiler-atherton/pieces.js';
import type { Question } from './question.js';

/** Something that is known at a step, under its name. */
export type Fact = readonly [name: string, said: string];

function windowFacts({ after, texts: page, language, header: { method } }: View): readonly Fact[] {
  const { window, apl, joined, way } = after.warnock ?? {};
  if (!window || !apl || !joined || !way) return [];
  const { length } = apl.entries;
  const listed = apl.entries
    .slice(0, mostOptions)
    .map(([id, surrounds]) => (surrounds ? `${id} (${page.surrounds})` : id));
  const others = length > mostOptions ? [page.more(length - mostOptions)] : [];
  return [
    [page.window, texts[language].numbers.windowText(window)],
    [page.apl, [...listed, ...others].join(', ')],
    ...(hasThreeLists(method) ? listFacts(way.length, joined, language) : []),
  ];
}

/** The level of a window, and the two lists beside the third. */
function listFacts(level: number, joined: Warnock['joined'], language: Language): readonly Fact[] {
  const { panel } = texts[language].family;
  const said = (list: Joined): string =>
    list.map((each) => `${each.polygon} (${panel.sinceLevel(each.level)})`).join(', ') || '∅';
  return [
    [panel.level, String(level)],
    [panel.surrounding, said(joined.surrounding)],
    [panel.outside, said(joined.outside)],
  ];
}

function scanlineFacts({ after, language }: View): readonly Fact[] {
  const { y } = after.zbuffer ?? {};
  return y == null ? [] : [['yₜ', texts[language].numbers.short(y)]];
}

/** The list in hand; before there is one, what will be sorted. */
const piecesOf = ({ inHand, facets }: Regions): readonly Piece[] => inHand?.pieces ?? facets;

/** The pieces with their outlines as one walks along them, and the polygons of the other lists, the top one first. */
function regionFacts({ after: { regions }, texts: page, language }: View): readonly Fact[] {
  if (regions === null) return [];
  const { regions: say, numbers } = texts[language];
  const pieces = piecesOf(regions);
  const listed = pieces.slice(0, mostOptions).map(([id, region, ground]) => {
    const loops = region.map((loop) => loop.map(numbers.point).join(' ')).join(' / ');
    return `${id}${ground ? ` (${say.ground})` : ''}: ${loops}`;
  });
  const others = pieces.length > mostOptions ? [page.more(pieces.length - mostOptions)] : [];
  const lists = [...regions.lists].reverse().map((list) => list.map(([id]) => id).join(', '));
  return [
    [regions.inHand === null ? say.pieces : say.list, [...listed, ...others].join('; ')],
    [say.lists, lists.join('; ') || '∅'],
  ];
}

/** In full, to be worked with. */
const vertices = (polygon: Polygon | undefined, { list, inFull }: Numbers): string =>
  (polygon?.vertices ?? []).map((vertex) => `(${list(vertex, inFull)})`).join(' ');

/** The polygons that a question is about. */
function idsOf({ after }: View, { about }: Question): readonly string[] {
  if (after.regions !== null) return ownersOf(piecesOf(after.regions));
  if ('polygon' in about) return [about.polygon];
  return after.warnock?.apl?.entries.map(([id]) => id) ?? [];
}

function polygonFacts(view: View, question: Question): readonly Fact[] {
  const { header, texts: page, language } = view;
  return idsOf(view, question).map((id) => [
    page.things.polygon(id),
    vertices(header.scene.byId.get(id), texts[language].numbers),
  ]);
}

/** What must be known at its step to answer a question, beside its own words and options. */
export function factsOf(view: View, question: Question): readonly Fact[] {
  const { area } = view.header.scene;
  const { predict, numbers } = texts[view.language];
  return [
    [predict.area, numbers.windowText([area.x, area.y, area.width, area.height])],
    ...windowFacts(view),
    ...scanlineFacts(view),
    ...regionFacts(view),
    ...polygonFacts(view, question),
  ];
}
