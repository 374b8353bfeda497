import type { TemplateResult } from 'lit';
import type { View } from '../algorithm/view.js';
import { polygonName, value } from '../elements/parts.js';
import { texts } from '../i18n/index.js';
import { containment } from './naming.js';
import type { Warnock } from './state.js';

/**
 * The values of a window with three lists: its level, the count of an outline so far, and the polygon that hides all
 * others.
 */
export function listValues(view: View, now: Warnock, old: Warnock): readonly TemplateResult[] {
  const { header, language, texts: page } = view;
  const { family, numbers } = texts[language];
  const { panel } = family;
  const sum = now.contained.length === 0 ? page.none : numbers.short(containment(now));
  const hiding = now.covering === null ? page.none : polygonName(now.covering, view);
  const name = header.method === 'warnock-angles' ? panel.octants : panel.ray;
  return [
    value(panel.level, now.way.length, now.way.length !== old.way.length),
    value(name, sum, now.contained !== old.contained),
    value(panel.hides, hiding, now.covering !== old.covering),
  ];
}
