import { css } from 'lit';

/**
 * Colours of the series after Okabe and Ito, a little darker on white: cool ones for Warnock's algorithm, warm ones for the
 * Z-buffer, and one for each kernel of curves.
 */
export const colors = css`
  :host {
    --right-wash: #e9f4ec;
    --warnock-bits: #0072b2;
    --warnock-depth: #56606f;
    --warnock-grid: #00825f;
    --warnock-window: #2f97d6;
    --warnock-fixed: #0072b2;
    --zbuffer-bits: #d55e00;
    --zbuffer-depth: #bd7b00;
    --zbuffer-grid: #b4568c;
    --zbuffer-window: #56606f;
    --zbuffer-fixed: #c24d00;
    --weiler-atherton-fixed: #c2185b;
    --variant-1: #8c5e00;
    --variant-2: #00608f;
    --variant-3: #a3416f;
    --variant-4: #00745a;
    --variant-5: #b34700;
    --variant-6: #5a3fc0;
    --variant-7: #56606f;
    --kernel-1: #0072b2;
    --kernel-2: #d55e00;
    --kernel-3: #00825f;
    --kernel-4: var(--ink);
    --kernel-5: #b4568c;
  }
  @media screen and (prefers-color-scheme: dark) {
    :host {
      --right-wash: #17281d;
      --warnock-bits: #3d9be0;
      --warnock-fixed: #3d9be0;
      --zbuffer-fixed: #f07a22;
      --warnock-depth: #9aa5b5;
      --warnock-grid: #19b98c;
      --warnock-window: #8fd0f5;
      --zbuffer-bits: #f07a22;
      --zbuffer-depth: #e69f00;
      --zbuffer-grid: #dd8fbb;
      --zbuffer-window: #9aa5b5;
      --weiler-atherton-fixed: #ff8fb3;
      --variant-1: #e0b458;
      --variant-2: #6cc3f2;
      --variant-3: #f0a0c8;
      --variant-4: #35d0a4;
      --variant-5: #ff9a55;
      --variant-6: #b3a2ff;
      --variant-7: #9aa5b5;
      --kernel-1: #3d9be0;
      --kernel-2: #f07a22;
      --kernel-3: #19b98c;
      --kernel-5: #dd8fbb;
    }
  }
  @media print {
    :host {
      --right-wash: #eeeeee;
    }
  }
`;
