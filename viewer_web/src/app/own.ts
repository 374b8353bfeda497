import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import '../elements/file-drop.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';

/** The ways to a scene of the reader's own. */
interface Ways {
  draw(): void;
  surface(name: string): void;
  files(files: readonly File[]): void;
}

/** The menu of these ways. A page that cannot run scenes only opens traces. */
export function own(canRun: boolean, language: Language, ways: Ways): TemplateResult {
  const { page, curves } = texts[language];
  const { surface } = curves;
  return html`<div class="own">
    ${
      canRun
        ? html`<button class="own-polygons" @click=${() => ways.draw()}>${page.drawOwn}</button>
            <button class="own-surface" @click=${() => ways.surface(surface.name)}>
              ${surface.own}
            </button>`
        : nothing
    }
    <vidno-file-drop
      .texts=${page}
      @files=${({ detail }: CustomEvent<readonly File[]>) => ways.files(detail)}
    ></vidno-file-drop>
  </div>`;
}
