import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { mostOptions } from '../predict/asker.js';
import type { Fact } from '../predict/facts.js';
import { hasThreeLists } from '../trace/events.js';
import type { Joined, Warnock } from './state.js';

/** The current window and its polygons. */
export function facts({ after, texts: page, language, header: { method } }: View): readonly Fact[] {
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

/** The level of a window, and the two lists besides the third. */
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

export const polygonsAsked = ({ after }: View, named: string | null): readonly string[] =>
  named === null ? (after.warnock?.apl?.entries ?? []).map(([id]) => id) : [named];
