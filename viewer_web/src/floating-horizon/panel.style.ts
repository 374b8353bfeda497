import { css } from 'lit';

export const horizonPanelStyle = css`
  .values.two {
    grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
  }
  .rows {
    table-layout: fixed;
  }
  .rows th:first-child {
    width: 3.8rem;
  }
  .rows th:nth-child(2) {
    width: 5.2rem;
  }
  .rows th[scope='row'] {
    font-size: 0.8125rem;
  }
  .rows td {
    overflow: hidden;
    font-size: 0.8125rem;
    text-overflow: ellipsis;
  }
  .rows tr.current :is(th, td) {
    font-weight: 700;
  }
`;
