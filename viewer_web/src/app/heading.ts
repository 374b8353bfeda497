import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import '../run/notice.js';
import type { Notice } from '../run/notice.js';
import './run-words.js';
import type { Session } from './session.js';

/** The title of the open run. */
export function heading(session: Session, name: string, language: Language): TemplateResult {
  const { trace, isCompared } = session;
  return html`<div class="title">
    <h2 title=${trace ? name : nothing}>${trace ? name : ''}</h2>
    ${
      trace === null || isCompared
        ? nothing
        : html`<vidno-run-words .header=${trace.header} .language=${language}></vidno-run-words>`
    }
  </div>`;
}

/** The notices about the open run, and about the run beside it. */
export function notices(session: Session, language: Language): TemplateResult {
  const { notice, rival } = session;
  const go = ({ detail: step }: CustomEvent<number>): void => session.move({ step });
  return html`${noticeOf(
    notice,
    language,
    () => session.stop(),
    go,
    () => session.coarsen(),
    () => session.live.save(),
  )}
  ${session.lacks === null ? nothing : noticeOf(session.lacks, language, () => undefined)}
  ${rival.notice === null ? nothing : noticeOf(rival.notice, language, () => rival.stop())}`;
}

/** A list of what can be opened, while nothing is open or about to be. */
export function invitation(session: Session, language: Language): TemplateResult | typeof nothing {
  if (session.trace !== null || session.isOpening) return nothing;
  return html`<p class="nothing">${texts[language].page.nothingOpen}</p>`;
}

function noticeOf(
  notice: Notice | null,
  language: Language,
  stop: () => void,
  go: ((event: CustomEvent<number>) => void) | null = null,
  coarsen: (() => void) | null = null,
  save: (() => void) | null = null,
): TemplateResult {
  return html`<vidno-notice
    class=${notice?.kind ?? nothing}
    .notice=${notice}
    .language=${language}
    ?leads=${go !== null}
    @stop=${stop}
    @go=${go}
    @coarsen=${coarsen}
    @save=${save}
  ></vidno-notice>`;
}
