import { LitElement, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { inWords, lossInWords } from '../language/library-reason.js';
import { noticeStyle } from '../elements/notice.style.js';
import { base } from '../elements/theme.js';
import { complaint, texts, wrongLine } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { NoWebAssembly } from '../replay/engine.js';
import type { Shortened } from '../replay/trace.js';
import { Unreadable } from '../replay/trace.js';
import type { Trace } from '../replay/trace.js';
import { unheld } from './packed.js';
import { details, numberOf } from '../trace/events.js';
import { faultsOf, inWordsOf, whyRefused } from './refusal.js';
import { emptySketch } from './sketch.js';

/** What a scene lacks of the mesh in a file, in the library's words. */
export interface Lacks {
  readonly kind: 'lacks';
  readonly name: string;
  readonly losses: readonly string[];
}

/** A notice about a file. */
export type Notice =
  | { readonly kind: 'reading'; readonly name: string }
  | { readonly kind: 'running' }
  | { readonly kind: 'growing'; readonly steps: number; readonly read: number }
  | { readonly kind: 'refused'; readonly name: string; readonly messages: string }
  /** The library could not read a mesh. */
  | { readonly kind: 'unread'; readonly name: string; readonly why: string }
  | { readonly kind: 'unknown'; readonly name: string }
  | { readonly kind: 'chart'; readonly name: string }
  | Lacks
  | { readonly kind: 'failed'; readonly name: string; readonly error: unknown }
  | ({ readonly kind: 'shortened' } & Shortened)
  /** The page has ended a run after these many steps, because it is too long. */
  | { readonly kind: 'long'; readonly steps: number; readonly isCoarse: boolean }
  /** The run lost something at these many steps, first at this one. */
  | { readonly kind: 'lost'; readonly step: number; readonly faults: number };

const fault = numberOf.get('fault') ?? -1;

/** The notice about a trace that is shown or being read. */
export function noticeOf({ complete, shortened, timeline, read }: Trace): Notice | null {
  if (!complete) return { kind: 'growing', steps: timeline.length, read };
  if (shortened) return { kind: 'shortened', ...shortened };
  const { names } = timeline;
  const first = names.indexOf(fault);
  if (first < 0) return null;
  let faults = 0;
  for (let at = first; at >= 0; at = names.indexOf(fault, at + 1)) faults += 1;
  return { kind: 'lost', step: first + 1, faults };
}

/** The notice about a run that the page has made. */
export function noticeOfRun(trace: Trace): Notice | null {
  const notice = noticeOf(trace);
  if (notice?.kind !== 'shortened' || notice.why !== 'partial') return notice;
  const { header, timeline } = trace;
  return { kind: 'long', steps: timeline.length, isCoarse: header.detail === details[0] };
}

/** Progress is not announced at each change. */
const roles = {
  reading: 'status',
  running: 'status',
  long: 'status',
  growing: nothing,
  unknown: 'alert',
  chart: 'alert',
  lacks: 'status',
  failed: 'alert',
  refused: 'alert',
  unread: 'alert',
  shortened: 'status',
  lost: 'status',
} as const;

/**
 * One line about a file that is being read, was refused, or is incomplete, or about a run that lost something. An event `stop`
 * asks to stop reading or running it, `go` to go to a step, `coarsen` to run the scene with fewer steps, and `save` to save
 * the scene.
 */
@customElement('vidno-notice')
export class NoticeElement extends LitElement {
  static override styles = [base, noticeStyle];

  @property({ attribute: false }) notice: Notice | null = null;
  @property({ attribute: false }) language: Language = 'en';
  /** Whether somebody hears `go`. */
  @property({ type: Boolean }) leads = false;

  override render(): TemplateResult | typeof nothing {
    const { notice } = this;
    if (notice === null) return nothing;
    return html`<p class=${notice.kind} role=${roles[notice.kind]}>${this.say(notice)}</p>
      ${this.details(notice)} ${this.stopOf(notice)}
      ${notice.kind === 'lost' && this.leads ? this.way(notice.step) : nothing}
      ${notice.kind === 'long' ? html`${notice.isCoarse ? nothing : this.coarser()} ${this.save()}` : nothing}`;
  }

  /** A shorter run, which the page can make as a whole. */
  private coarser(): TemplateResult {
    return html`<button @click=${() => this.dispatchEvent(new CustomEvent('coarsen'))}>
      ${texts[this.language].page.coarsen}
    </button>`;
  }

  /** The scene as a file, of which the program makes all steps. */
  private save(): TemplateResult {
    return html`<button @click=${() => this.dispatchEvent(new CustomEvent('save'))}>
      ${texts[this.language].page.saveLong}
    </button>`;
  }

  /** The way to a step. */
  private way(step: number): TemplateResult {
    const go = (): boolean => this.dispatchEvent(new CustomEvent<number>('go', { detail: step }));
    return html`<button @click=${go}>
      ${texts[this.language].page.goToLoss(step.toLocaleString(this.language))}
    </button>`;
  }

  /** A list of several errors in a file, or of what a scene lacks. */
  private details(notice: Notice): TemplateResult | typeof nothing {
    const { scene } = texts[this.language];
    if (notice.kind === 'lacks') {
      return listOf(notice.losses.map((loss) => lossInWords(loss, scene)));
    }
    const all = notice.kind === 'refused' ? faultsOf(notice.messages) : [];
    return all.length < 2 ? nothing : listOf(all.map((fault) => inWordsOf(fault, scene)));
  }

  private stopOf({ kind }: Notice): TemplateResult | typeof nothing {
    if (kind !== 'reading' && kind !== 'growing' && kind !== 'running') return nothing;
    return html`<button @click=${() => this.dispatchEvent(new CustomEvent('stop'))}>
      ${texts[this.language].page.stopReading}
    </button>`;
  }

  private sayRefused({ name, messages }: Notice & { readonly kind: 'refused' }): string {
    const { page, scene } = texts[this.language];
    const [fault, ...others] = faultsOf(messages);
    if (fault === undefined || others.length > 0) return page.refusedFor(name);
    const why =
      fault.line === null ? whyRefused(messages, emptySketch, scene) : inWordsOf(fault, scene);
    return page.refusedScene(name, why);
  }

  private say(notice: Notice): string {
    const { page } = texts[this.language];
    if (notice.kind === 'reading') return page.reading(notice.name);
    if (notice.kind === 'running') return page.running;
    if (notice.kind === 'long') return page.long(notice.steps.toLocaleString(this.language));
    if (notice.kind === 'unknown') {
      return notice.name === unheld ? page.unheld : page.unknown(notice.name);
    }
    if (notice.kind === 'lost') {
      return page.lost(notice.faults, notice.step.toLocaleString(this.language));
    }
    if (notice.kind === 'chart') return page.isChart(notice.name);
    if (notice.kind === 'unread') {
      return inWords(notice.why, texts[this.language].scene);
    }
    if (notice.kind === 'lacks') return page.lacks(notice.name);
    if (notice.kind === 'refused') {
      return this.sayRefused(notice);
    }
    if (notice.kind === 'growing') {
      const steps = notice.steps.toLocaleString(this.language);
      return page.growing(steps, Math.round(100 * notice.read));
    }
    if (notice.kind === 'shortened') {
      return notice.why === 'wrong'
        ? wrongLine(notice, this.language)
        : page.shortened[notice.why](notice.line);
    }
    if (notice.error instanceof Unreadable) {
      return complaint(notice.name, notice.error, this.language);
    }
    if (notice.error instanceof NoWebAssembly) return page.noWebAssembly;
    return page.broken(notice.name);
  }
}

const listOf = (items: readonly string[]): TemplateResult =>
  html`<ul class="faults" tabindex="0">
    ${items.map((item) => html`<li>${item}</li>`)}
  </ul>`;
