import { css } from 'lit';

export const listingStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
  }
  ol {
    list-style: none;
  }
  .head {
    display: flex;
    flex: none;
    height: 2.6rem;
    padding: 0 0.5rem 0 0.75rem;
    border-bottom: 1px solid var(--line);
  }
  .head button {
    display: var(--tools, block);
    visibility: var(--quiet, visible);
    align-self: center;
    padding: 0 0.5rem;
    font: 600 0.75rem var(--mono);
  }
  .head button[aria-pressed='true'] {
    border-color: var(--accent);
    background: var(--accent-wash);
    color: var(--accent);
  }
  .calls {
    display: flex;
    flex: 1;
    flex-wrap: wrap;
    min-width: 0;
    align-content: center;
    overflow: hidden;
    white-space: nowrap;
    font-size: 0.75rem;
    line-height: 1.3;
    color: var(--soft);
  }
  .calls li + li::before {
    content: '›';
    margin: 0 0.5em;
  }
  .calls li:last-child {
    color: var(--ink);
  }
  .procedures {
    position: relative;
    flex: 1;
    min-height: 0;
    overflow: auto;
    padding-bottom: 0.75rem;
    scrollbar-width: thin;
  }
  .procedures:focus-visible {
    outline-offset: -3px;
  }
  h3 {
    margin-top: 0.6rem;
    padding: 0.2rem 0.75rem;
    font: 0.8125rem / 1.4 var(--mono);
    letter-spacing: 0;
  }
  .name {
    font-weight: 700;
    color: var(--ink);
  }
  .title {
    margin-left: 0.4em;
    font: 0.75rem var(--sans);
    white-space: nowrap;
  }
  .entered h3 {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
    color: var(--ink);
  }
  li {
    position: relative;
  }
  section li {
    display: grid;
    grid-template-columns: 2.5rem 1fr auto;
    align-items: baseline;
    padding: 0.14rem 0.75rem;
    font-size: 0.8125rem;
    line-height: 1.4;
  }
  .at {
    color: var(--soft);
    font: 0.6875rem var(--mono);
  }
  code {
    display: flow-root;
    padding-left: calc(var(--indent) * 1rem + 0.8rem);
    text-indent: -0.8rem;
    font-family: var(--sans);
    overflow-wrap: anywhere;
  }
  var {
    float: right;
    box-sizing: border-box;
    width: min(14rem, max(37%, min(60%, 8.75rem)));
    min-height: 1.4em;
    padding-left: 0.4rem;
    overflow: hidden;
    color: var(--accent);
    font: 0.75rem / 1.4 var(--mono);
    text-align: right;
    text-indent: 0;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  var.long {
    width: auto;
    max-width: 100%;
    overflow-wrap: anywhere;
    white-space: normal;
  }
  .now {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
  }
  .now :is(.at, var) {
    color: inherit;
  }
  .mark {
    display: inline-block;
    width: 1.1em;
    margin-left: 0.15em;
    /* With opacity, the browser would composite each mark separately. */
    color: color-mix(in srgb, var(--soft) 55%, transparent);
    font: normal 0.75rem / 1 var(--mono);
    text-align: center;
    cursor: pointer;
  }
  /* Not part of the line's text, for copying and for screen readers. */
  .mark::after {
    content: '≠';
  }
  li:hover .mark,
  .now .mark {
    color: var(--accent);
  }
  @media (forced-colors: active) {
    .now .mark,
    .entered h3 *,
    [aria-current] :is(.at, var) {
      color: inherit;
    }
  }
  .break {
    margin-right: 0.35rem;
  }
  .caller {
    background: var(--caller);
    box-shadow: inset 3px 0 color-mix(in srgb, var(--now-edge) 45%, transparent);
  }
  @container (min-width: 1500px) {
    section li {
      font-size: 0.9375rem;
    }
    h3 {
      font-size: 0.9375rem;
    }
  }
  .defect {
    margin-left: 0.5rem;
    padding: 0 0.35em;
    border-radius: 4px;
    background: var(--bad-wash);
    color: var(--bad);
    font: 600 0.6875rem / 1.5 var(--mono);
    text-decoration: none;
    cursor: help;
  }
  /* Only the running procedures: those of the line and of its callers. */
  @media print {
    .mark {
      display: none;
    }
    .procedures {
      overflow: hidden;
    }
    section li {
      padding-block: 0;
    }
    .procedures:has(.now, .caller, .entered) section:not(:has(.now, .caller), .entered) {
      display: none;
    }
    .now {
      border: 0.5mm solid #000000;
      font-weight: 600;
    }
  }
`;
