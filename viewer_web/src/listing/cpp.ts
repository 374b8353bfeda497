import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import type { View } from '../algorithm/view.js';
import { base } from '../elements/theme.js';
import { Follower } from '../picture/in-sight.js';
import { sourcesOf, linesThatReport } from './sources.js';
import type { Source, SourceLine } from './sources.js';

/** The C++ of the procedures, with the lines that recorded the step. */
@customElement('vidno-cpp')
export class CppElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        flex: 1;
        min-height: 0;
      }
      .files {
        position: relative;
        height: 100%;
        padding-bottom: 0.75rem;
        overflow: auto;
        scrollbar-width: thin;
      }
      h3 {
        position: sticky;
        top: 0;
        z-index: 1;
        padding: 0.35rem 0.75rem;
        border-bottom: 1px solid var(--line);
        background: var(--panel);
        font: 600 0.75rem / 1.4 var(--mono);
        color: var(--ink);
      }
      ol {
        padding: 0.4rem 0;
        list-style: none;
      }
      li {
        display: flow-root;
        min-height: 1.45em;
        padding: 0 0.75rem 0 calc(0.75rem + var(--indent) * 0.5ch + 2ch);
        font: 0.75rem / 1.45 var(--mono);
        text-indent: -2ch;
        overflow-wrap: anywhere;
      }
      .comment {
        color: var(--soft);
        font-family: var(--sans);
      }
      .now {
        background: var(--now);
        box-shadow: inset 3px 0 var(--now-edge);
      }
      @container (min-width: 1500px) {
        li {
          font-size: 0.875rem;
        }
      }
    `,
  ];

  @property({ attribute: false }) view!: View;

  @query('.files') private files!: HTMLElement;
  private sources: readonly Source[] = [];
  private shown = '';
  private readonly follower = new Follower();

  override willUpdate(): void {
    const { method, edition } = this.view.header;
    if (this.shown === `${method} ${edition}`) return;
    this.shown = `${method} ${edition}`;
    this.sources = sourcesOf({ method, edition });
  }

  override render(): TemplateResult {
    return html`<div class="files" tabindex="0" role="region" aria-label=${this.view.texts.source}>
      ${this.sources.map((source) => this.file(source))}
    </div>`;
  }

  private file(source: Source): TemplateResult {
    const { event } = this.view;
    const now = event === null ? [] : linesThatReport(event, source);
    return html`<section>
      <h3>${source.path}</h3>
      <ol>
        ${source.lines.map((line, i) => this.line(line, now.includes(i)))}
      </ol>
    </section>`;
  }

  private line({ indent, text }: SourceLine, now: boolean): TemplateResult {
    const kind = now ? 'now' : text.startsWith('//') ? 'comment' : nothing;
    return html`<li
      class=${kind}
      aria-current=${now ? 'step' : nothing}
      .style=${`--indent: ${indent}`}
    >
      ${text}
    </li>`;
  }

  override updated(): void {
    // Before the first step the listing is at its beginning.
    const what = this.view.step === 0 ? 'section' : '.now';
    const mark = this.renderRoot.querySelector<HTMLElement>(what);
    this.follower.follow(this.files, mark, 32);
  }
}
