import { css } from 'lit';

export const bookmarksStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 0.5rem;
    min-height: 0;
    overflow: auto;
    padding: 0.6rem 0.75rem;
    scrollbar-width: thin;
    font-size: 0.8125rem;
  }
  .head {
    display: flex;
    flex-wrap: wrap;
    gap: 0.25rem 0.6rem;
    align-items: center;
    justify-content: space-between;
  }
  .add {
    padding: 0 0.7rem;
  }
  kbd {
    color: var(--soft);
    font: 0.8125rem var(--mono);
  }
  .count,
  .hint {
    color: var(--soft);
  }
  .limit:not(:empty) {
    padding: 0.4rem 0.6rem;
    border-radius: 6px;
    background: var(--warn-wash);
    color: var(--warn);
  }
  ol {
    display: grid;
    gap: 0.25rem;
    list-style: none;
  }
  li {
    display: grid;
    grid-template-columns: minmax(3.4rem, auto) minmax(0, 1fr) 2rem;
    align-items: start;
    gap: 0.3rem;
    padding: 0.15rem 0.2rem;
    border-radius: 6px;
  }
  .now {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
  }
  .go {
    padding: 0 0.4rem;
    text-align: right;
  }
  textarea {
    width: 100%;
    min-height: 2rem;
    padding: 0.3rem 0.45rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--well);
    color: inherit;
    font: inherit;
    line-height: 1.35;
    overflow-wrap: anywhere;
    resize: none;
    field-sizing: content;
  }
  textarea::placeholder {
    color: var(--soft);
    opacity: 1;
  }
  .remove {
    padding: 0;
    line-height: 1;
  }
  @container (min-width: 1500px) {
    :host {
      font-size: 0.9375rem;
    }
  }
`;
