import type { Page } from 'playwright-core';

/** The first screen of the page. */
export interface Seen {
  /** The side of a square picture and the width of its panel, in CSS pixels. */
  readonly side: number;
  readonly panel: number;
  /** The names of all controls: everything to press, type into or choose from, except links. */
  readonly controls: readonly string[];
}

/** Inspects every shadow tree. Covered, scrolled-away and invisible elements do not count. */
export function see(page: Page): Promise<Seen> {
  return page.evaluate(() => {
    const all: HTMLElement[] = [];
    const walk = (root: ParentNode): void => {
      for (const each of root.querySelectorAll<HTMLElement>('*')) {
        all.push(each);
        if (each.shadowRoot) walk(each.shadowRoot);
      }
    };
    walk(document);
    const isIn = (inner: Element | null, outer: Element): boolean => {
      for (let at: Node | null = inner; at !== null;) {
        if (at === outer) return true;
        at = at instanceof ShadowRoot ? at.host : at.parentNode;
      }
      return false;
    };
    const isSeen = (each: Element): boolean => {
      const { left, top, width, height } = each.getBoundingClientRect();
      if (width < 2 || height < 2 || !each.checkVisibility({ visibilityProperty: true }))
        return false;
      const [x, y] = [left + width / 2, top + height / 2];
      let found = document.elementFromPoint(x, y);
      for (let deeper = found; deeper?.shadowRoot;) {
        deeper = deeper.shadowRoot.elementFromPoint(x, y);
        if (deeper === found) break;
        found = deeper ?? found;
      }
      return isIn(found, each);
    };
    const picture = all.find(
      (each) => each.localName === 'vidno-picture' && each.checkVisibility(),
    );
    const box = picture?.getBoundingClientRect() ?? new DOMRect();
    // The margins around an area on both sides together, as a share of its longer side.
    const margins = Math.min(box.width, box.height) < 420 ? 0.1 : 0.14;
    const panel = all.find((each) => each.localName === 'section' && each.matches('.picture'));
    return {
      side: Math.min(box.width, box.height) / (1 + margins),
      panel: panel?.getBoundingClientRect().width ?? 0,
      controls: all
        .filter((each) => each.matches('button, input, select, textarea, summary') && isSeen(each))
        .map((each) => each.getAttribute('aria-label') ?? each.textContent.trim()),
    };
  });
}
