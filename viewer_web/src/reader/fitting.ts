/** No smaller than this part of its size; what is still wider is scrolled. */
const least = 0.6;
/** So often the browser is asked how wide a thing has become: not all of it gets smaller in proportion. */
const tries = 3;

/** What is as wide as its box lets it be, and shows the rest by scrolling. */
export type Wide = Pick<HTMLElement, 'scrollWidth' | 'clientWidth' | 'style'>;

/** Makes a formula or a table that is wider than its box smaller, as `--fit` says, until its end is in sight. */
export function fit(wide: Wide): void {
  wide.style.removeProperty('--fit');
  let size = 1;
  for (let i = 0; i < tries && wide.scrollWidth > wide.clientWidth && size > least; i++) {
    size = Math.max(least, (size * (wide.clientWidth - 1)) / wide.scrollWidth);
    wide.style.setProperty('--fit', size.toFixed(3));
  }
}

/** Fits what there is in an article, now and whenever its width is another or a part of it is opened. */
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
