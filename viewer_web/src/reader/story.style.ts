import { css } from 'lit';
import { formulaStyle } from '../elements/formula.style.js';

/** A textbook's page: lines of 60 to 70 letters where there is room. */
export const storyStyle = [
  css`
    article {
      max-width: 36rem;
      margin: 0 auto;
      padding: 1.1rem 1.25rem 2rem;
      font: 1.0625rem / 1.58 var(--serif);
      hyphens: auto;
      hanging-punctuation: first allow-end;
      overflow-wrap: break-word;
      text-wrap: pretty;
    }
    h2,
    h3,
    h4 {
      color: var(--ink);
      font-family: var(--serif);
      font-weight: 600;
      letter-spacing: -0.01em;
      line-height: 1.25;
      hyphens: manual;
      text-wrap: balance;
      scroll-margin-top: 1rem;
    }
    h2 {
      margin-bottom: 1.1rem;
      font-size: 1.625rem;
    }
    h3 {
      margin: 2.1rem 0 0.6rem;
      font-size: 1.25rem;
    }
    h4 {
      margin: 1.6rem 0 0.4rem;
      font-size: 1.0625rem;
    }
    :is(h3, h4):focus {
      outline: none;
    }
    .anchor {
      padding: 0 0.2em;
      color: var(--soft);
      font-weight: 400;
      text-decoration: none;
      opacity: 0;
    }
    :is(h3, h4):hover .anchor,
    .anchor:focus-visible {
      opacity: 1;
    }
    p,
    ul,
    ol,
    blockquote,
    figure,
    pre,
    .formula,
    .table,
    vidno-command {
      margin: 0 0 0.85em;
    }
    :is(ul, ol) {
      padding-left: 1.5em;
    }
    li {
      margin-bottom: 0.3em;
    }
    li > p {
      margin-bottom: 0.3em;
    }
    blockquote {
      padding-left: 1em;
      border-left: 3px solid var(--line);
      color: var(--soft);
    }
    code,
    pre {
      font-family: var(--mono);
      font-size: 0.84em;
      hyphens: none;
    }
    pre {
      padding: 0.7rem 0.85rem;
      overflow: auto;
      border: 1px solid var(--line);
      border-radius: 6px;
      background: var(--well);
      font-size: 0.8125rem;
      line-height: 1.5;
    }
    pre code {
      font-size: 1em;
    }
    a {
      color: var(--accent);
      text-decoration-thickness: 1px;
      text-underline-offset: 0.18em;
    }
    .pin {
      padding: 0.06em 0.14em;
      margin: 0 -0.14em;
      border-radius: 4px;
      text-decoration: underline dotted;
      text-decoration-thickness: 1.5px;
      box-decoration-break: clone;
      -webkit-box-decoration-break: clone;
    }
    .pin:hover {
      background: var(--accent-wash);
    }
    .pin[aria-current] {
      background: var(--now);
      color: var(--ink);
      text-decoration-color: var(--now-edge);
      text-decoration-style: solid;
    }
    figure img {
      display: block;
      max-width: 100%;
      margin: 0 auto 0.6rem;
      padding: 0.4rem;
      border-radius: 4px;
      background: #ffffff;
    }
    .gallery {
      display: grid;
      grid-template-columns: repeat(auto-fill, minmax(7.5rem, 1fr));
      gap: 0 1rem;
    }
    /* Many small figures: the commands would be longer than the captions. */
    .gallery:has(> figure:nth-child(3)) vidno-command {
      display: none;
    }
    figcaption {
      color: var(--soft);
      font-size: 0.875em;
      line-height: 1.45;
    }
    .table {
      overflow-x: auto;
    }
    table {
      margin: 0 auto;
      border-block: 1.5px solid var(--soft);
      font-size: calc(0.875em * var(--fit, 1));
      line-height: 1.4;
      font-variant-numeric: lining-nums tabular-nums;
    }
    th {
      border-bottom: 1px solid var(--soft);
      font-weight: 600;
      vertical-align: bottom;
    }
    :is(th, td) {
      padding: 0.3em 0.6em;
      text-align: left;
      hyphens: manual;
    }
    td {
      vertical-align: top;
    }
    :is(th, td).right {
      text-align: right;
    }
    :is(th, td).center {
      text-align: center;
    }
    .frame {
      margin: 0 0 1.5em;
      padding: 0.8rem 1rem 0.4rem;
      border: 1px solid var(--line);
      border-radius: 6px;
      font: 0.875rem / 1.5 var(--sans);
    }
    .frame dl {
      margin: 0 0 0.4rem;
    }
    .frame dl > div {
      margin: 0 0 0.2rem;
    }
    .frame :is(dt, .label) {
      color: var(--soft);
      font-weight: 600;
    }
    .frame :is(dt, dd, dd ul, dd li) {
      display: inline;
      margin: 0 0.4em 0 0;
      padding: 0;
    }
    .frame dd li + li::before {
      content: '· ';
    }
    /* Rows of targets need 24 pixels each. */
    .frame .term {
      display: inline-block;
      line-height: 1.75;
    }
    .frame .label {
      margin-bottom: 0.2rem;
    }
    .frame ul {
      margin: 0;
      padding-left: 1.2em;
    }
    .frame li {
      margin: 0 0 0.15em;
    }
    .listing {
      margin: 0 0 1.1em;
      padding: 0.5rem 0;
      border-block: 1px solid var(--line);
      hyphens: none;
      text-wrap: wrap;
    }
    .listing p {
      margin: 0.35rem 0 0.2rem;
      font: 0.8125rem / 1.4 var(--mono);
    }
    .listing .title {
      margin-left: 0.4em;
      color: var(--soft);
      font: 0.75rem var(--sans);
    }
    .listing ol {
      margin: 0 0 0.4rem;
      padding: 0;
      list-style: none;
    }
    .listing li {
      display: grid;
      grid-template-columns: 2.5rem 1fr auto;
      align-items: baseline;
      margin: 0;
      padding: 0.1rem 0;
      font: 0.8125rem / 1.4 var(--sans);
    }
    .listing .at {
      color: var(--soft);
      font: 0.6875rem var(--mono);
    }
    .listing code {
      padding-left: calc(var(--indent) * 1rem + 0.8rem);
      text-indent: -0.8rem;
      font: inherit;
      overflow-wrap: anywhere;
    }
    .listing .defects {
      padding-left: 0.6rem;
      color: var(--bad);
      font: 0.6875rem var(--mono);
    }
    .sources {
      font-size: 0.9em;
    }
    .answers {
      display: none;
    }
    .question {
      margin: 0 0 1.1em;
      padding: 0.8rem 1rem;
      border-left: 3px solid var(--accent);
      border-radius: 0 6px 6px 0;
      background: var(--well);
    }
    .question .number {
      margin-bottom: 0.25rem;
      color: var(--soft);
      font: 600 0.75rem var(--sans);
      letter-spacing: 0.02em;
    }
    .question > :nth-last-child(2) {
      margin-bottom: 0.4rem;
    }
    summary {
      width: fit-content;
      padding: 0.1rem 0.4rem 0.1rem 0;
      border-radius: 4px;
      color: var(--accent);
      font: 0.875rem / 1.75rem var(--sans);
      cursor: pointer;
    }
    .answer {
      padding-top: 0.35rem;
    }
    .answer > :last-child {
      margin-bottom: 0.2rem;
    }
    @media (max-width: 1199px) {
      article {
        padding-inline: 1.25rem;
      }
    }
  `,
  formulaStyle,
];
