import { html } from 'lit';
import type { TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import temml from 'temml';
import type { Language } from '../language/language.js';

/** A TeX formula as MathML, on a line of its own or in text. Invalid TeX is shown as written. */
export function formula(source: string, language: Language, isOnItsOwn = false): TemplateResult {
  const tex = withNumbersIn(language, source);
  return html`${guard([tex, isOnItsOwn], () => mathOf(tex, isOnItsOwn))}`;
}

/**
 * A formula of a story, which both languages write alike, with its numbers as the language writes them. Russian has a decimal
 * comma, so a semicolon separates decimal numbers.
 */
export function withNumbersIn(language: Language, tex: string): string {
  if (language === 'en') return tex;
  const grouped = tex.replace(/(?<=\d)\{,\}(?=\d{3})/gu, '\\,');
  if (!/\d\.\d/u.test(tex)) return grouped;
  return grouped.replace(/(?<![\\{]),/gu, ';').replace(/(?<=\d)\.(?=\d)/gu, '{,}');
}

function mathOf(tex: string, displayMode: boolean): Node | TemplateResult {
  const box = document.createElement('span');
  try {
    temml.render(tex, box, { displayMode, throwOnError: true });
    return box.firstChild ?? html``;
  } catch {
    return html`<code class="tex">${tex}</code>`;
  }
}
