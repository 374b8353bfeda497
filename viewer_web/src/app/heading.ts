import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { texts } from '../i18n/index.js';
import { editionName } from '../language/family-texts.js';
import type { Language } from '../language/language.js';
import '../run/notice.js';
import type { Notice } from '../run/notice.js';
import type { Session } from './session.js';

/** What is open, and what there is to say of it and of the run beside it. */
export function heading(session: Session, name: string, language: Language): TemplateResult {
  const { trace, notice, rival } = session;
  return html`<div class="title">
    <h2>${trace ? name : ''}</h2>
    ${session.isCompared ? nothing : runOf(session, language)}
    ${noticeOf(notice, language, () => session.stop())}
    ${rival.notice === null ? nothing : noticeOf(rival.notice, language, () => rival.stop())}
  </div>`;
}

/** What can be opened, where nothing is and nothing is about to be. */
export function invitation(session: Session, language: Language): TemplateResult | typeof nothing {
  if (session.trace !== null || session.isOpening) return nothing;
  return html`<p class="nothing">${texts[language].page.nothingOpen}</p>`;
}

function runOf({ trace }: Session, language: Language): TemplateResult | typeof nothing {
  if (trace === null) return nothing;
  const { page, scene } = texts[language];
  const { method, edition, kernel, detail } = trace.header;
  return html`<p>
    ${page.methods[method]} · ${editionName(page.editions, edition)} · ${page.kernel}: ${kernel} ·
    ${page.detail}: ${scene.details[detail]}
  </p>`;
}

function noticeOf(notice: Notice | null, language: Language, stop: () => void): TemplateResult {
  return html`<vidno-notice
    class=${notice?.kind ?? nothing}
    .notice=${notice}
    .language=${language}
    @stop=${stop}
  ></vidno-notice>`;
}
