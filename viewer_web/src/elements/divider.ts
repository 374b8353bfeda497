import { LitElement, css } from 'lit';
import type { PropertyValues } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { memory } from '../base/memory.js';
import { base } from './theme.js';

/** The least and the greatest share of the whole before a divider, and the step of a key. */
const least = 0.2;
const largest = 0.8;
const stride = 0.02;

/**
 * A line between two parts of a grid, its neighbours in the document, which can be dragged. It sets their sizes as custom
 * properties of its parent, `--NAME` and `--NAME-rest` in fr, and `--NAME-share` from 0 to 1, and stores them. Until it is
 * moved, the parent's style determines the sizes.
 */
@customElement('vidno-divider')
export class DividerElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        position: relative;
        z-index: 1;
        border-radius: 4px;
        cursor: col-resize;
        touch-action: none;
        user-select: none;
      }
      :host([level]) {
        cursor: row-resize;
      }
      /* A short line along it, for both orientations. */
      :host::after {
        content: '';
        position: absolute;
        inset: 4px;
        max-width: 2rem;
        max-height: 2rem;
        margin: auto;
        border-radius: 2px;
        background: var(--line);
      }
      :host(:is(:hover, :focus-visible, [dragged]))::after {
        background: var(--accent);
      }
      :host(:focus-visible) {
        outline: 3px solid var(--accent);
        outline-offset: -2px;
      }
      @media print {
        :host {
          display: none;
        }
      }
    `,
  ];

  /** The name of the part before it in its parent's style. */
  @property() name = '';
  /** The name under which its position is stored: the same part may have another size elsewhere. */
  @property() place = '';
  @property() label = '';

  override connectedCallback(): void {
    super.connectedCallback();
    this.role = 'separator';
    this.tabIndex = 0;
    this.addEventListener('pointerdown', this.onDown);
    this.addEventListener('keydown', this.onKey);
    this.addEventListener('dblclick', this.reset);
    this.addEventListener('focus', this.tell);
    this.addEventListener('pointerenter', this.tell);
  }

  override updated(changed: PropertyValues<this>): void {
    this.ariaLabel = this.label;
    this.ariaValueMin = String(100 * least);
    this.ariaValueMax = String(100 * largest);
    if (!changed.has('place') && !changed.has('name')) return;
    const kept = Number.parseFloat(memory.get(this.key) ?? '');
    this.set(kept >= least && kept <= largest ? kept : null);
    this.ariaValueNow ??= '50';
  }

  private get key(): string {
    return `${this.place}.${this.name}`;
  }

  /** The extent that it divides: whether the line is horizontal, and the start and length in the direction of movement. */
  private whole(): { readonly isLevel: boolean; readonly from: number; readonly length: number } {
    const [before, after] = [this.previousElementSibling, this.nextElementSibling];
    const one = before?.getBoundingClientRect() ?? new DOMRect();
    const other = after?.getBoundingClientRect() ?? new DOMRect();
    const isLevel = other.top >= one.bottom || one.top >= other.bottom;
    const from = isLevel ? Math.min(one.top, other.top) : Math.min(one.left, other.left);
    const to = isLevel ? Math.max(one.bottom, other.bottom) : Math.max(one.right, other.right);
    return { isLevel, from, length: Math.max(to - from, 1) };
  }

  /** The share before a point of the page. */
  private shareAt(x: number, y: number): number {
    const { isLevel, from, length } = this.whole();
    return ((isLevel ? y : x) - from) / length;
  }

  /** The current share of the part before it. */
  private get share(): number {
    const { left, top, width, height } = this.getBoundingClientRect();
    return this.shareAt(left + width / 2, top + height / 2);
  }

  private move(share: number): void {
    const kept = Math.min(Math.max(share, least), largest);
    memory.set(this.key, kept.toFixed(3));
    this.set(kept);
  }

  private set(share: number | null): void {
    const root = this.getRootNode();
    const whole = this.parentElement ?? (root instanceof ShadowRoot ? root.host : null);
    const style = whole instanceof HTMLElement ? whole.style : undefined;
    const parts = (of: number): readonly string[] => [
      `${(100 * of).toFixed(2)}fr`,
      `${(100 * (1 - of)).toFixed(2)}fr`,
      of.toFixed(4),
    ];
    const names = [`--${this.name}`, `--${this.name}-rest`, `--${this.name}-share`];
    names.forEach((name, i) => {
      if (share === null) style?.removeProperty(name);
      else style?.setProperty(name, parts(share)[i] ?? '');
    });
    if (share !== null) this.ariaValueNow = String(Math.round(100 * share));
  }

  private readonly tell = (): void => {
    const { isLevel } = this.whole();
    this.toggleAttribute('level', isLevel);
    this.ariaOrientation = isLevel ? 'horizontal' : 'vertical';
    this.ariaValueNow = String(Math.round(100 * this.share));
  };

  private readonly reset = (): void => {
    memory.set(this.key, '');
    this.set(null);
  };

  private readonly onDown = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    event.preventDefault();
    this.setPointerCapture(event.pointerId);
    this.toggleAttribute('dragged', true);
    const onMove = ({ clientX, clientY }: PointerEvent): void =>
      this.move(this.shareAt(clientX, clientY));
    const end = new AbortController();
    const onEnd = (): void => {
      end.abort();
      this.toggleAttribute('dragged', false);
    };
    this.addEventListener('pointermove', onMove, { signal: end.signal });
    this.addEventListener('pointerup', onEnd, { signal: end.signal });
    this.addEventListener('pointercancel', onEnd, { signal: end.signal });
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const [less, more] = this.whole().isLevel
      ? ['ArrowUp', 'ArrowDown']
      : ['ArrowLeft', 'ArrowRight'];
    if (event.key === less) this.move(this.share - stride);
    else if (event.key === more) this.move(this.share + stride);
    else if (event.key === 'Home') this.move(least);
    else if (event.key === 'End') this.move(largest);
    else if (event.key === 'Enter') this.reset();
    else return;
    event.preventDefault();
  };
}
