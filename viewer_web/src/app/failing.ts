import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import '../atlas/failure-note.js';
import type { Shown } from './stage.js';

/** The note on the open failure. */
export function failing({ session, setup, ways }: Shown): TemplateResult | typeof nothing {
  const { failure, rival, trace } = session;
  if (failure === null || trace === null || setup.presenting) return nothing;
  return html`<vidno-failure-note
    .failure=${failure}
    .unproved=${failure.unproved}
    .language=${setup.language}
    ?there=${session.isFailing}
    ?comparing=${rival.chosen !== null}
    @go=${() => {
      ways.leave();
      session.move({ step: Math.min(failure.step ?? 0, session.steps) });
    }}
    @compare=${() => {
      ways.leave();
      session.compareWithRemedy();
    }}
    @forget=${() => session.forgetFailure()}
  ></vidno-failure-note>`;
}
