import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import { OwnDots } from '../picture/own-dots.js';
import type { Course } from '../time/course.js';
import { wholeOf } from '../time/range.js';
import type { Range } from '../time/range.js';
import { stripHeight } from './lanes.js';
import { lookOf, stripColors } from './look.js';
import { StripPainter } from './paint.js';

/** A run, or a part of it, as a strip. It does not change from step to step. */
@customElement('vidno-strip')
export class StripElement extends LitElement {
  static override styles = [
    base,
    stripColors,
    css`
      :host,
      canvas {
        display: block;
      }
      canvas {
        width: 100%;
        height: 100%;
      }
    `,
  ];

  /** The course of the whole run; null until it was analysed. */
  @property({ attribute: false }) course: Course | null = null;
  /** The visible part; null for the whole. */
  @property({ attribute: false }) range: Range | null = null;
  /** Whether only the current item is shown. */
  @property({ type: Boolean }) bare = false;
  @query('canvas') private canvas!: HTMLCanvasElement;

  private readonly dots = new OwnDots(this, () => this.canvas);

  override updated(): void {
    const { canvas, course } = this;
    const { width, height } = this.dots.value;
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d');
    if (course === null || context === null || width < 1 || height < 1) return;
    const look = lookOf(this, height / stripHeight);
    const range = this.range ?? wholeOf(course.length);
    const painter = new StripPainter(context, course, look, range);
    if (this.bare) painter.paintBare();
    else painter.paint();
  }

  override render(): TemplateResult {
    return html`<canvas aria-hidden="true"></canvas>`;
  }
}
