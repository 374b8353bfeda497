import { css } from 'lit';

export const regionsPanelStyle = css`
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
    overflow: hidden;
    font-size: 0.75rem;
    color: var(--soft);
    text-overflow: ellipsis;
  }
  .rows td.number {
    text-align: right;
  }
`;
