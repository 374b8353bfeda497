import { css } from 'lit';

export const regionsPanelStyle = css`
  .values.found {
    grid-template-columns: minmax(min-content, 1.45fr) minmax(min-content, 1.25fr) minmax(
        min-content,
        0.85fr
      );
    gap: 0.35rem 0.6rem;
    align-items: end;
  }
  .found dt {
    white-space: normal;
  }
  .lists.two {
    grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
  }
  .list.short {
    height: 4.9rem;
  }
  .list.hand {
    height: 6.6rem;
  }
  .list.visible {
    height: 8.2rem;
  }
  .rows td.said {
    font-size: 0.75rem;
    line-height: 1.3;
    color: var(--soft);
    white-space: normal;
  }
  .rows td.number {
    text-align: right;
  }
`;
