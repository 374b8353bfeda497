import { css } from 'lit';

/**
 * Colours of the series after Okabe and Ito, a little darker on white: cool ones for Warnock's algorithm, warm ones for
 * the Z-buffer; of curves one a kernel.
 */
export const colors = css`
  :host {
    --band: #eef1f5;
    --front: #171b24;
    --warnock-bits: #0072b2;
    --warnock-depth: #56606f;
    --warnock-grid: #00825f;
    --warnock-window: #2f97d6;
    --warnock-fixed: var(--ink);
    --zbuffer-bits: #d55e00;
    --zbuffer-depth: #bd7b00;
    --zbuffer-grid: #b4568c;
    --zbuffer-window: #56606f;
    --zbuffer-fixed: var(--ink);
    --weiler-atherton-fixed: #c2185b;
    --warnock-simplest-fixed: #8c5e00;
    --warnock-full-fixed: #00608f;
    --warnock-angles-fixed: #a3416f;
    --warnock-vertex-fixed: #00745a;
    --warnock-edges-fixed: #b34700;
    --warnock-bodies-fixed: #5a3fc0;
    --float: #0072b2;
    --double: #d55e00;
    --filtered: #00825f;
    --exact: var(--ink);
  }
  @media (prefers-color-scheme: dark) {
    :host {
      --band: #222833;
      --front: #ffffff;
      --warnock-bits: #3d9be0;
      --warnock-depth: #9aa5b5;
      --warnock-grid: #19b98c;
      --warnock-window: #8fd0f5;
      --zbuffer-bits: #f07a22;
      --zbuffer-depth: #e69f00;
      --zbuffer-grid: #dd8fbb;
      --zbuffer-window: #9aa5b5;
      --weiler-atherton-fixed: #ff8fb3;
      --warnock-simplest-fixed: #e0b458;
      --warnock-full-fixed: #6cc3f2;
      --warnock-angles-fixed: #f0a0c8;
      --warnock-vertex-fixed: #35d0a4;
      --warnock-edges-fixed: #ff9a55;
      --warnock-bodies-fixed: #b3a2ff;
      --float: #3d9be0;
      --double: #f07a22;
      --filtered: #19b98c;
    }
  }
`;
