/** The least scale. What is still too wide scrolls. */
const least = 0.6;
/** The number of times to measure the width: not every part shrinks in proportion. */
const tries = 3;

/** An element that is as wide as its box allows, and scrolls the rest. */
export type Wide = Pick<HTMLElement, 'scrollWidth' | 'clientWidth' | 'style'>;

/** Shrinks a formula or a table that is wider than its box by means of `--fit`, until its end is in sight. */
export function fit(wide: Wide): void {
  wide.style.removeProperty('--fit');
  let size = 1;
  for (let i = 0; i < tries && wide.scrollWidth > wide.clientWidth && size > least; i++) {
    size = Math.max(least, (size * (wide.clientWidth - 1)) / wide.scrollWidth);
    wide.style.setProperty('--fit', size.toFixed(3));
  }
}

/** Fits the content of an article, now and whenever its width changes or a part of it is opened. */
export class Fitting {
  private readonly widths = new ResizeObserver(() => this.fit());

  constructor(private readonly article: () => HTMLElement | null) {}

  watch(box: HTMLElement): void {
    this.widths.observe(box);
    box.addEventListener('toggle', () => this.fit(), { capture: true });
  }

  stop(): void {
    this.widths.disconnect();
  }

  fit(): void {
    this.article()?.querySelectorAll<HTMLElement>('.formula, .table').forEach(fit);
  }
}
