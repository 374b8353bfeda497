import type { ReactiveController, ReactiveControllerHost } from 'lit';

/**
 * The distance of the reading line from the top of the visible part of a text: a third of the height in the middle of the
 * text, less near its beginning and more near its end, so that the line passes the whole text. All in pixels: the scroll
 * position, its maximum, and the visible height.
 */
export function readingLine(scrolled: number, most: number, height: number): number {
  if (most <= 0) return 0;
  const third = height / 3;
  const first = Math.min(third, most / 3);
  const last = Math.min(2 * third, (2 * most) / 3);
  if (scrolled < first) return (third * scrolled) / first;
  const over = scrolled - (most - last);
  return over > 0 ? third + (2 * third * over) / last : third;
}

/** The scroll position at which the line is at a place, given in pixels below the beginning of the text. */
export function scrolledTo(place: number, most: number, height: number): number {
  let [low, high] = [0, Math.max(0, most)];
  while (high - low > 0.25) {
    const middle = (low + high) / 2;
    if (middle + readingLine(middle, most, height) < place) low = middle;
    else high = middle;
  }
  return high;
}

/** A place in the text to scroll to; null for its beginning. Each goal is a new object. */
export interface Goal {
  readonly place: string | null;
  /** Whether the reader continues there, so that the run may follow. */
  readonly isRead: boolean;
}

/** The names of the places nearest above the reading line. */
export interface Reached {
  /** A pin or a heading. */
  readonly place: string | null;
  readonly pin: string | null;
  readonly heading: string | null;
}

/** The number of a part of the text, and the share of it above the reading line. */
interface Kept {
  readonly part: number;
  readonly above: number;
}

const isPin = ({ classList }: Element): boolean => classList.contains('pin');

/** The text as elements: an article of consecutive parts in a scrolling box. */
interface Read extends ReactiveControllerHost {
  readonly box: HTMLElement;
  readonly article: HTMLElement;
  /** The reader has reached another place; `isScrolled` if by scrolling. */
  reached(now: Reached, isScrolled: boolean): void;
}

/** The reader's place in a text. It is kept when the layout of the text changes. */
export class ReadingPlace implements ReactiveController {
  private kept: Kept | null = null;
  /** The position to which the page itself has scrolled. */
  private own = 0;
  private last = '';
  /** Whether the keyboard focus has moved to a part of the text, to which the browser then scrolls. */
  private isFocusing = false;
  private readonly sizes = new ResizeObserver(() => this.restore());

  constructor(private readonly host: Read) {
    host.addController(this);
  }

  /** To be called when the box exists. */
  watch(): void {
    const { box } = this.host;
    box.addEventListener('scroll', this.onScroll, { passive: true });
    box.addEventListener('focusin', this.onFocus);
    // A picture has a height only after it has loaded.
    box.addEventListener('load', () => this.restore(), { capture: true });
    this.sizes.observe(box);
  }

  hostDisconnected(): void {
    this.sizes.disconnect();
  }

  /** Scrolls to a place, or to the beginning: a heading near the top, a pin at the reading line. */
  show({ place, isRead }: Goal): void {
    const { box } = this.host;
    const mark = this.marks().find(({ dataset }) => dataset['place'] === place);
    if (mark === undefined) {
      this.scrollTo(0);
      return;
    }
    const top = this.topOf(mark) + box.scrollTop;
    this.scrollTo(isPin(mark) ? this.scrolledTo(top + 4) : top - 16);
    this.tell(isRead, place);
    if (!isPin(mark)) mark.focus({ preventScroll: true });
  }

  /** Scrolls back to the place before the layout of the text changed. */
  restore(): void {
    const { kept, host } = this;
    const part = kept && host.article.children[kept.part];
    if (!part || host.box.clientHeight === 0) return;
    const { height } = part.getBoundingClientRect();
    const top = this.topOf(part) + host.box.scrollTop;
    this.scrollTo(this.scrolledTo(top + kept.above * height), kept);
  }

  private scrollTo(top: number, kept: Kept | null = null): void {
    const { box } = this.host;
    box.scrollTop = top;
    this.own = box.scrollTop;
    this.kept = kept ?? this.keep();
    this.tell(false);
  }

  private readonly onScroll = (): void => {
    const { box } = this.host;
    if (box.clientHeight === 0 || Math.abs(box.scrollTop - this.own) < 1) return;
    this.own = -1;
    this.kept = this.keep();
    this.tell(!this.isFocusing);
  };

  /** Moving the focus is not reading; the browser reports its scrolling in the next frame. */
  private readonly onFocus = (): void => {
    this.isFocusing = true;
    requestAnimationFrame(() => requestAnimationFrame(() => (this.isFocusing = false)));
  };

  /** Reports the places above the reading line, or the requested place. */
  private tell(isScrolled: boolean, asked: string | null = null): void {
    const line = this.line();
    const above = this.marks().filter((mark) => this.topOf(mark) <= line);
    const place = (marks: readonly HTMLElement[]): string | null =>
      marks.at(-1)?.dataset['place'] ?? null;
    const now: Reached = {
      place: asked ?? place(above),
      pin: place(above.filter(isPin)),
      heading: place(above.filter((mark) => !isPin(mark))),
    };
    const said = JSON.stringify(now);
    if (said === this.last) return;
    this.last = said;
    this.host.reached(now, isScrolled);
  }

  private keep(): Kept {
    const parts = [...this.host.article.children];
    const line = this.line();
    const below = parts.findIndex(
      (part) => part.getBoundingClientRect().bottom - this.top() > line,
    );
    const part = below < 0 ? parts.length - 1 : below;
    const box = parts[part]?.getBoundingClientRect();
    if (box === undefined) return { part: 0, above: 0 };
    return { part, above: (line - (box.top - this.top())) / Math.max(1, box.height) };
  }

  /** The visible headings and pins, in the order of the text. */
  private marks(): readonly HTMLElement[] {
    const marks = this.host.article.querySelectorAll<HTMLElement>('[data-place]');
    return [...marks].filter((mark) => mark.checkVisibility());
  }

  private line(): number {
    return readingLine(this.host.box.scrollTop, this.most, this.host.box.clientHeight);
  }

  private scrolledTo(place: number): number {
    return scrolledTo(place, this.most, this.host.box.clientHeight);
  }

  private get most(): number {
    return this.host.box.scrollHeight - this.host.box.clientHeight;
  }

  private top(): number {
    return this.host.box.getBoundingClientRect().top;
  }

  private topOf(part: Element): number {
    return part.getBoundingClientRect().top - this.top();
  }
}
