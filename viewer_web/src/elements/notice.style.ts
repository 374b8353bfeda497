import { css } from 'lit';

/** One line about a file. */
export const noticeStyle = css`
  p:is(
    .reading,
    .running,
    .failed,
    .refused,
    .unread,
    .unknown,
    .chart,
    .lacks,
    .shortened,
    .long,
    .lost
  ) {
    margin-top: 0.3rem;
    padding: 0.45rem 0.7rem;
    border-radius: 6px;
    background: var(--accent-wash);
    font-size: 0.875rem;
    overflow-wrap: anywhere;
  }
  p:is(.reading, .running, .growing) {
    display: inline-block;
    margin-right: 0.4rem;
  }
  button {
    min-height: 1.5rem;
    padding: 0 0.5rem;
    font-size: 0.8125rem;
  }
  p.growing {
    color: var(--soft);
    font-size: 0.8125rem;
    font-variant-numeric: tabular-nums;
  }
  p:is(.failed, .refused, .unread, .unknown, .chart) {
    background: var(--bad-wash);
    color: var(--bad);
  }
  .faults {
    max-height: 6.5rem;
    margin: 0.3rem 0 0;
    padding-left: 1.6rem;
    overflow: auto;
    color: var(--bad);
    font-size: 0.875rem;
    overflow-wrap: anywhere;
  }
  p.lost {
    display: inline-block;
    margin-right: 0.4rem;
  }
  p:is(.shortened, .long, .lost) {
    background: var(--warn-wash);
    color: var(--warn);
  }
`;
