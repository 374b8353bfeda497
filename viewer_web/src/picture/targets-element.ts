import { LitElement, css, html, nothing, svg } from 'lit';
import type { SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import type { Frame } from './frame.js';
import { overlayStyle } from './picture.style.js';
import { pointIn } from './own-size.js';
import { shapesOf } from './shapes.js';
import type { Target } from './target.js';

/** The targets of a question over the picture, by mouse, finger or keyboard. */
@customElement('vidno-targets')
export class TargetsElement extends LitElement {
  static override styles = [
    base,
    overlayStyle,
    css`
      path {
        vector-effect: non-scaling-stroke;
        fill: none;
        stroke-linejoin: round;
        stroke-linecap: round;
      }
      g {
        cursor: pointer;
        pointer-events: stroke;
      }
      .inner {
        pointer-events: all;
      }
      .reach {
        stroke: transparent;
        stroke-width: 16;
      }
      .casing {
        stroke: #ffffff;
        stroke-width: 7;
      }
      .look {
        stroke: #5a1fc4;
        stroke-width: 2.5;
        stroke-dasharray: 4 5;
      }
      g:hover .look,
      g:focus-visible .look {
        stroke-width: 4;
        stroke-dasharray: none;
      }
      g:focus-visible {
        outline: none;
      }
      g:focus-visible .casing {
        stroke: #10131c;
        stroke-width: 10;
      }
      .chosen .look {
        stroke-width: 5;
        stroke-dasharray: none;
      }
      .chosen.inner .look {
        fill: #5a1fc4;
        fill-opacity: 0.45;
      }
    `,
  ];

  @property({ attribute: false }) targets: readonly Target[] = [];
  /** The position of the plane in the picture. */
  @property({ attribute: false }) frame!: Frame;

  override render(): TemplateResult {
    const { targets, frame } = this;
    return html`<svg viewBox=${frame.shown.join(' ')}>
      ${targets.map((each) => this.target(each))}
    </svg>`;
  }

  /** Points may lie so close together that the areas around them overlap: a click chooses the nearest. */
  private choose(event: MouseEvent, target: Target): void {
    const isByPointer = event.detail > 0;
    const isPoint = target.mark.kind === 'point';
    (isByPointer && isPoint ? this.nearest(event, target) : target).press();
  }

  private nearest(event: MouseEvent, target: Target): Target {
    const [x, y] = this.frame.at(...pointIn(this, event));
    const far = ({ mark }: Target): number =>
      mark.kind === 'point' ? Math.hypot(mark.at[0] - x, mark.at[1] - y) : Infinity;
    return this.targets.reduce((best, each) => (far(each) < far(best) ? each : best), target);
  }

  private target(target: Target): SVGTemplateResult {
    const { mark, label, role, isChosen, press } = target;
    const [{ d } = { d: '' }] = shapesOf(mark, this.frame.scale);
    const isInner = mark.kind !== 'path' || mark.closed;
    return svg`<g
      class="${isInner ? 'inner' : ''} ${isChosen ? 'chosen' : ''}"
      tabindex="0"
      role=${role}
      aria-label=${label}
      aria-checked=${role === 'button' ? nothing : String(isChosen)}
      @mousedown=${(event: Event) => event.preventDefault()}
      @click=${(event: MouseEvent) => this.choose(event, target)}
      @keydown=${(event: KeyboardEvent) => onKey(event, press)}
    >
      <path class="reach" d=${d} />
      <path class="casing" d=${d} />
      <path class="look" d=${d} />
    </g>`;
  }
}

function onKey(event: KeyboardEvent, press: () => void): void {
  if (event.key !== 'Enter' && event.key !== ' ') return;
  event.preventDefault();
  press();
}
