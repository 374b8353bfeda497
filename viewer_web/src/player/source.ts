import { html, nothing } from 'lit';
import type { ReactiveController, ReactiveControllerHost, TemplateResult } from 'lit';
import type { Language } from '../language/language.js';
import { openTrace } from '../replay/open.js';
import type { Trace } from '../replay/trace.js';
import { noticeOf } from '../run/notice.js';
import type { Notice } from '../run/notice.js';

/** An element that shows the trace named by `src`. */
export interface Sourced extends ReactiveControllerHost, HTMLElement {
  readonly src: string;
  step: number;
  trace: Trace | null;
  length: number;
}

/** Waits until the whole document is read, including everything behind the player. */
async function documentRead(): Promise<void> {
  if (document.readyState !== 'loading') return;
  await new Promise((resolve) => {
    document.addEventListener('DOMContentLoaded', resolve, { once: true });
  });
}

/** The file at an address, or, for `#id`, the text of a block of data in the page. */
async function fileOf(src: string): Promise<Blob> {
  if (!src.startsWith('#')) {
    const response = await fetch(src);
    if (!response.ok) throw new Error(`${response.status}`);
    return response.blob();
  }
  await documentRead();
  const block = document.getElementById(src.slice(1));
  if (block === null) throw new Error('not in the page');
  return new Blob([`${block.textContent.trim()}\n`]);
}

/** Reads the trace named by its host's `src`, again whenever that changes. */
export class Source implements ReactiveController {
  private notice: Notice | null = null;
  private opened = '';
  private stopReading = (): void => undefined;

  constructor(private readonly host: Sourced) {
    host.addController(this);
  }

  hostUpdate(): void {
    const { src } = this.host;
    if (src === this.opened) return;
    this.opened = src;
    this.host.toggleAttribute('failed', false);
    this.stopReading();
    if (src !== '') void this.open(src);
  }

  hostConnected(): void {
    this.host.requestUpdate();
  }

  /** An element that moves elsewhere in the document reads its trace again. */
  hostDisconnected(): void {
    this.stopReading();
    this.opened = '';
  }

  /** A message in place of a trace, or about an incomplete one. */
  remark(language: Language): TemplateResult | typeof nothing {
    if (this.notice === null) return nothing;
    return html`<vidno-notice
      .notice=${this.notice}
      .language=${language}
      leads
      @stop=${() => this.stop()}
      @go=${({ detail: step }: CustomEvent<number>) => this.go(step)}
    ></vidno-notice>`;
  }

  private go(step: number): void {
    this.host.step = step;
  }

  /** Stops reading and keeps the steps read so far. */
  private stop(): void {
    this.stopReading();
    const { host } = this;
    host.trace?.end('stopped');
    host.length = host.trace?.timeline.length ?? 0;
    this.notice = host.trace && noticeOf(host.trace);
    host.requestUpdate();
  }

  private async open(src: string): Promise<void> {
    this.notice = { kind: 'reading', name: src };
    try {
      const file = await fileOf(src);
      if (src === this.opened) this.read(file, src);
    } catch (error) {
      if (src === this.opened) this.fail(src, error);
    }
  }

  private read(file: Blob, name: string): void {
    const { host } = this;
    this.stopReading = openTrace(file, {
      grown: (trace) => {
        const { length } = trace.timeline;
        if (!trace.complete && length < host.step) return;
        this.notice = trace.complete ? noticeOf(trace) : null;
        host.length = length;
        host.trace = trace;
      },
      failed: (error) => this.fail(name, error),
    });
  }

  private fail(name: string, error: unknown): void {
    this.notice = { kind: 'failed', name, error };
    this.host.trace = null;
    this.host.toggleAttribute('failed', true);
    this.host.requestUpdate();
  }
}
