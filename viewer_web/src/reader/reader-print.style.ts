import { css } from 'lit';

/** The printed text: A4, lines of 140 mm, with hidden parts shown and buttons left out. */
export const readerPrint = css`
  @media print {
    :host {
      display: block;
      overflow: visible;
      border: 0;
    }
    .bar,
    nav.long,
    .anchor {
      display: none;
    }
    .box {
      overflow: visible;
    }
    article {
      max-width: 146mm;
      padding: 0;
      font-size: 11pt;
      line-height: 1.45;
      orphans: 2;
      widows: 2;
    }
    h2 {
      margin-bottom: 8mm;
      font-size: 20pt;
    }
    h3 {
      font-size: 14pt;
    }
    h4 {
      font-size: 11.5pt;
    }
    :is(h2, h3, h4),
    p:has(+ :is(pre, vidno-command, figure, .gallery, .formula, .table, .listing, ul, ol)),
    vidno-command:has(+ pre) {
      break-after: avoid;
    }
    /* Chromium divides a paragraph of three lines, which is too short for both orphans and widows. */
    p.short,
    figure,
    tr,
    .table:not(:has(tbody tr:nth-child(13))),
    pre,
    .formula {
      break-inside: avoid;
    }
    pre {
      font-size: 7pt;
      white-space: pre-wrap;
    }
    .pin,
    .lesson {
      padding: 0;
      margin: 0;
      background: none !important;
      color: inherit;
      text-decoration: none;
    }
    .pin::after {
      content: ' [' attr(data-step) ']';
      color: var(--soft);
      font: 0.72em var(--sans);
      white-space: nowrap;
    }
    .link {
      color: inherit;
    }
    .link::after {
      content: ' (' attr(href) ')';
      font-size: 0.8em;
      overflow-wrap: anywhere;
    }
    .question {
      padding: 0 0 0 4mm;
      border-left-width: 1.5pt;
      border-left-color: var(--line);
      break-inside: avoid;
    }
    .question details {
      display: none;
    }
    .answers {
      display: block;
    }
    .answers .number {
      margin: 0.8em 0 0.2em;
      color: var(--soft);
      font: 600 8.5pt var(--sans);
      break-after: avoid;
    }
    .listing ol,
    .frame,
    .sources {
      break-inside: avoid;
    }
    .listing p {
      break-after: avoid;
    }
    .listing :is(p, li) {
      font-size: 8.5pt;
    }
    figure img {
      padding: 0;
      max-height: 190mm;
    }
    .gallery {
      grid-template-columns: repeat(auto-fill, minmax(40mm, 1fr));
    }
  }
`;
