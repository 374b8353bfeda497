import { css } from 'lit';

/** The line at the top of a page: its name, its subject, and tools. */
export const headerStyle = css`
  header {
    grid-area: header;
    display: flex;
    gap: 0.9rem;
    align-items: center;
  }
  h1 {
    margin: 0;
    font: 700 1.375rem var(--mono);
    letter-spacing: -0.03em;
    color: var(--accent);
  }
  .tagline {
    color: var(--soft);
    white-space: nowrap;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .tools {
    display: flex;
    gap: 0.75rem;
    margin-left: auto;
  }
  @media (max-width: 640px) {
    .tagline {
      display: none;
    }
  }
  @media (max-width: 380px) {
    header {
      gap: 0.5rem;
    }
  }
`;
