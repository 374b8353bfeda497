import { css } from 'lit';

/** The history of a pixel: its colour, and below it a scrolling list. */
export const historyStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
    overflow: auto; /* a low panel scrolls as a whole */
  }
  .hint {
    padding: 0.75rem;
    color: var(--soft);
  }
  .head {
    display: grid;
    flex: none;
    grid-template-columns: auto minmax(0, 1fr) auto;
    gap: 0.5rem;
    align-items: center;
    padding: 0.5rem 0.75rem;
    border-bottom: 1px solid var(--line);
  }
  .color .swatch {
    width: 1.5rem;
    height: 1.5rem;
    margin: 0;
    border-radius: 4px;
    vertical-align: middle;
  }
  .forget {
    width: 2rem;
    padding: 0;
    line-height: 1;
  }
  .last {
    font-size: 0.8125rem;
  }
  .entries {
    position: relative;
    flex: 1;
    min-height: 5rem;
    overflow: auto;
    padding-bottom: 0.75rem;
    scrollbar-width: thin;
  }
  ol {
    list-style: none;
  }
  h3 {
    position: sticky;
    top: 0;
    z-index: 1;
    padding: 0.35rem 0.75rem;
    border-bottom: 1px solid var(--line);
    background: var(--panel);
    letter-spacing: 0;
    white-space: nowrap;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  section + section h3 {
    border-top: 1px solid var(--line);
  }
  li {
    font-size: 0.8125rem;
    line-height: 1.4;
  }
  li button {
    display: grid;
    grid-template-columns: 1.1rem minmax(0, 1fr) auto;
    gap: 0 0.4rem;
    width: 100%;
    min-height: 1.75rem;
    padding: 0.2rem 0.75rem 0.2rem 0.6rem;
    border: 0;
    border-radius: 0;
    background: none;
    text-align: left;
    overflow-wrap: anywhere;
  }
  li button:hover {
    background: var(--well);
  }
  li button:focus-visible {
    outline-offset: -3px;
  }
  .sign {
    font-weight: 700;
    text-align: center;
  }
  .sign .swatch {
    margin: 0;
  }
  .pass .sign {
    color: var(--good);
  }
  .fail .sign {
    color: var(--soft);
  }
  .wrong .sign,
  .wrong .said {
    color: var(--bad);
  }
  .painter .said {
    font-weight: 600;
  }
  .step {
    color: var(--soft);
    font-size: 0.6875rem;
    line-height: 1.65;
  }
  .later .said {
    color: var(--soft);
  }
  .reached button {
    box-shadow: inset 0 -2px color-mix(in srgb, var(--now-edge) 60%, transparent);
  }
  .now button,
  .now button:hover {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
  }
  .now .step,
  .now .said {
    color: inherit;
  }
  .exactly {
    color: var(--bad);
  }
  .why {
    display: grid;
    flex: none;
    margin: 0.6rem 0.75rem 0;
    font-size: 0.8125rem;
    padding: 0.45rem 0.6rem;
    border-left: 3px solid var(--accent);
    border-radius: 0 5px 5px 0;
    background: var(--accent-wash);
  }
  .why > span,
  .why::after {
    grid-area: 1 / 1;
  }
  .why::after {
    content: attr(data-longest);
    visibility: hidden;
  }
  .more {
    margin: 0.5rem 0.75rem;
    padding: 0 0.7rem;
    font-size: 0.8125rem;
  }
  @container (min-width: 1500px) {
    li,
    .why,
    .last {
      font-size: 0.9375rem;
    }
    .step {
      font-size: 0.75rem;
      line-height: 1.75;
    }
    h3 {
      font-size: 0.8125rem;
    }
  }
  li.pointed {
    background: none;
    box-shadow: inset -3px 0 var(--pointed);
  }
`;
