import { css } from 'lit';

/** Fixed tools and a message, and under them the form, which scrolls. */
export const scenePanelStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
    font-size: 0.8125rem;
  }
  .tools {
    display: flex;
    flex: none;
    flex-wrap: wrap;
    gap: 0.3rem;
    padding: 0.5rem 0.75rem 0;
  }
  .tools button {
    padding: 0 0.55rem;
  }
  .tools .close {
    margin-left: auto;
    padding: 0;
  }
  .draw[aria-pressed='true'] {
    background: var(--accent);
    border-color: var(--accent);
    color: var(--on-accent);
  }
  .message {
    flex: none;
    height: 4.4rem;
    margin: 0.5rem 0.75rem;
    padding: 0.3rem 0.5rem;
    overflow: auto;
    border-radius: 6px;
    background: var(--well);
    color: var(--soft);
    font-size: 0.75rem;
  }
  .message span {
    white-space: pre-line;
  }
  .message.refused {
    background: var(--bad-wash);
    color: var(--bad);
  }
  .scroll {
    position: relative;
    flex: 1;
    min-height: 0;
    overflow: auto;
    padding: 0 0.75rem 0.75rem;
    scrollbar-width: thin;
  }
  .icon {
    width: 2rem;
    font-size: 1.05rem;
    line-height: 1;
  }
`;
