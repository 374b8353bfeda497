import { css } from 'lit';

/** For screen readers only. */
export const hiddenStyle = css`
  .heard {
    position: absolute;
    width: 1px;
    height: 1px;
    margin: -1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
`;
