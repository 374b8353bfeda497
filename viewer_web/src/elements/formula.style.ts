import { css } from 'lit';

/** Formulas in a system font with tables for mathematics; the classes are those of Temml. */
export const formulaStyle = css`
  math {
    font-family:
      'Cambria Math', 'STIX Two Math', 'Latin Modern Math', 'Libertinus Math',
      'DejaVu Math TeX Gyre', math;
    font-size-adjust: 0.47; /* as high as the letters of the text, whichever font there is */
    line-height: normal;
    hyphens: none;
  }
  .formula {
    padding: 0.15em 0;
    overflow: auto hidden;
    text-align: center;
  }
  .formula math {
    display: block math;
    margin: 0;
    font-size: calc(1em * var(--fit, 1));
  }
  @media print {
    :is(.formula, .table) {
      --fit: 1 !important;
    }
  }
  .glued {
    white-space: nowrap;
  }
  .tml-right {
    text-align: -webkit-right;
    text-align: right;
  }
  .tml-left {
    text-align: -webkit-left;
    text-align: left;
  }
  mtable.tml-jot > mtr > mtd {
    padding-block: 0.7ex;
  }
`;
