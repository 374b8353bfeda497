import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { adviceRows, adviceText } from '../advice.js';
import type { AdviceRow } from '../advice.js';
import type { Point } from '../points.js';
import type { Shown } from '../shown.js';
import { axesOf } from '../subject.js';
import { costAmount, errorAmount, fullName } from '../words.js';
import { amount, tableStyle } from './table.js';

/** Which run to choose: one sentence, and a table of three runs. */
@customElement('vidno-advice')
export class AdviceElement extends LitElement {
  static override styles = [
    base,
    tableStyle,
    css`
      :host {
        display: block;
      }
      h2 {
        font-size: 1em;
      }
      p {
        margin: 0.2em 0 0.5em;
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;

  override render(): TemplateResult {
    const { texts, cost, view } = this.shown;
    const [wrong] = axesOf(view.subjects).errors;
    return html`<h2>${texts.whichRun}</h2>
      <p>${adviceText(this.shown)}</p>
      <table>
        <thead>
          <tr>
            <td></td>
            <th scope="col">${texts.run}</th>
            <th scope="col">${texts.costs[cost].name}</th>
            <th scope="col">${texts.errors[wrong].name}</th>
          </tr>
        </thead>
        <tbody>
          ${adviceRows(this.shown).map((row) => this.row(row, wrong))}
        </tbody>
      </table>`;
  }

  private row({ title, point }: AdviceRow, error: Shown['error']): TemplateResult {
    const { shown } = this;
    if (point === null) {
      return html`<tr>
        <th scope="row">${title}</th>
        <td colspan="3">${shown.texts.noRun}</td>
      </tr>`;
    }
    return html`<tr>
      <th scope="row">${title}</th>
      <td>
        <button @click=${() => this.choose(point)}>${fullName(point.setting, shown)}</button>
      </td>
      ${amount(costAmount(point, shown))} ${amount(errorAmount(point, { ...shown, error }))}
    </tr>`;
  }

  private choose(point: Point): void {
    this.dispatchEvent(new CustomEvent('point', { detail: point }));
  }
}
