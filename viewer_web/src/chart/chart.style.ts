import { css } from 'lit';

export const chartStyle = css`
  :host {
    box-sizing: border-box;
    display: grid;
    min-height: 100dvh;
    padding: 0 0.6rem 0.6rem;
    gap: 0 0.9rem;
    grid-template: 'header' 3.25rem 'choices' auto 'main' auto 'side' auto / minmax(0, 1fr);
    background: var(--paper);
  }
  vidno-choices {
    grid-area: choices;
    padding-bottom: 0.7rem;
  }
  .notice {
    padding-bottom: 0.6rem;
  }
  main {
    grid-area: main;
    display: flex;
    flex-direction: column;
    min-width: 0;
    min-height: 0;
  }
  .alone {
    grid-column: 1 / -1;
  }
  .panel {
    padding: 0.7rem 0.9rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  .plot {
    padding: 0.4rem;
  }
  vidno-plot {
    height: 28rem;
  }
  .about {
    padding: 0.6rem 0.2rem;
    color: var(--soft);
  }
  .about h2 {
    margin: 0;
    font-size: 1em;
    color: var(--ink);
  }
  aside {
    grid-area: side;
    display: flex;
    flex-direction: column;
    gap: 0.75rem;
    min-width: 0;
    min-height: 0;
  }
  .empty {
    display: grid;
    gap: 0.8rem;
    width: min(38rem, 100%);
    margin: 12vh auto 0;
  }
  code {
    display: block;
    padding: 0.6rem 0.8rem;
    border-radius: 6px;
    background: var(--well);
    font-family: var(--mono);
    overflow-wrap: anywhere;
  }
  @media (min-width: 1100px) {
    :host {
      height: 100dvh;
      min-height: 38rem;
      padding: 0 0.9rem 0.9rem;
      grid-template:
        'header header' 3.25rem 'choices choices' auto 'main side' minmax(0, 1fr)
        / minmax(0, 1fr) clamp(23rem, 27vw, 34rem);
    }
    .plot {
      flex: 1;
      min-height: 0;
    }
    vidno-plot {
      height: 100%;
    }
    .about {
      padding-bottom: 0;
    }
    .front {
      flex: 0 1 auto;
      min-height: 8rem;
      overflow: auto;
      scrollbar-width: thin;
    }
  }
  @media (min-width: 1600px) {
    :host {
      font-size: 1.125rem;
    }
  }
`;
