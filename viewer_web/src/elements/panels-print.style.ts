import { css } from 'lit';
import { mostPrinted } from './lists.js';

/** On paper a list states the number of further rows. */
export const panelsPrint = css`
  .on-paper {
    display: none;
  }
  @media print {
    :host,
    .list {
      overflow: hidden;
    }
    .counted tr:nth-child(n + ${mostPrinted + 1}),
    .on-screen {
      display: none;
    }
    .on-paper {
      display: block;
    }
    .stack {
      min-height: 0;
    }
    .apl {
      height: auto;
    }
  }
`;
