import { css } from 'lit';

/** Over the content, for long enough to be read, without moving anything. */
export const announcerStyle = css`
  .news {
    position: absolute;
    z-index: 4;
    bottom: 100%;
    left: 50%;
    width: max-content;
    max-width: min(36rem, 100%);
    transform: translate(-50%, -0.5rem);
  }
  .news {
    pointer-events: none;
  }
  .news span:not(.heard, :empty) {
    display: block;
    padding: 0.5rem 0.9rem;
    border-radius: 6px;
    background: var(--ink);
    color: var(--panel);
  }
  .news span:not(.heard, :empty) {
    animation: gone 0.3s 7s forwards;
  }
  @keyframes gone {
    to {
      visibility: hidden;
      opacity: 0;
    }
  }
`;
