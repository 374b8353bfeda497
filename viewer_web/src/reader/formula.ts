import { html } from 'lit';
import type { TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import temml from 'temml';

/** A TeX formula as MathML, on a line of its own or in text. Invalid TeX is shown as written. */
export function formula(tex: string, isOnItsOwn = false): TemplateResult {
  return html`${guard([tex, isOnItsOwn], () => mathOf(tex, isOnItsOwn))}`;
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
