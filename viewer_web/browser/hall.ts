import type { Page } from 'playwright-core';
import type { AppElement } from '../src/app/app.js';

/** Presents the open run in the language; its steps to look at, the first and the last among them. */
export async function presentIn(page: Page, language: string): Promise<readonly number[]> {
  await page.waitForFunction(
    (wanted) => {
      const app = document.querySelector<AppElement>('vidno-app');
      const player = app?.shadowRoot?.querySelector('vidno-player');
      if (!player?.trace?.complete || player.lang !== wanted) return false;
      if (!player.presenting) player.present(true);
      return player.hasAttribute('presenting');
    },
    language,
    { polling: 50 },
  );
  return page.evaluate(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    const last = player?.last ?? 0;
    // Half of them follow one another, half are spread over the run.
    const near = Math.min(last, Math.floor(last / 3));
    const steps = Array.from({ length: 25 }, (_, i) => [near + i, Math.round((i * last) / 24)]);
    return [...new Set(steps.flat())].filter((step) => step <= last).sort((a, b) => a - b);
  });
}

/** What is wrong in the hall at some of the steps: whatever is cut off, small, empty, out of sight, overlapping or moved. */
export function faultsInHall(page: Page, steps: readonly number[]): Promise<readonly string[]> {
  return page.evaluate(async (all) => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    const root = player?.shadowRoot;
    if (!player || !root) throw new Error('no player');
    const faults = new Map<string, number>();
    let step = 0;
    const fault = (what: string, where: string): void => {
      const said = `${what}: ${where.replace(/\s+/g, ' ').trim().slice(0, 60)}`;
      if (!faults.has(said)) faults.set(said, step);
    };
    const frame = (): Promise<unknown> =>
      new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    const parts = { picture: '.picture', listing: '.listing', state: '.side', sentence: '.dock' };
    const part = (selector: string): HTMLElement | null => root.querySelector(selector);

    /** The box of an element, read once a step, and whether it cuts off what sticks out. */
    let boxes = new Map<Element, DOMRect>();
    const boxOf = (e: Element): DOMRect => {
      const known = boxes.get(e) ?? e.getBoundingClientRect();
      boxes.set(e, known);
      return known;
    };
    const cutting = new Map<Element, boolean>();
    const isCutting = (e: Element): boolean => {
      const known = cutting.get(e);
      if (known !== undefined) return known;
      const { overflowX, overflowY, contain, display } = getComputedStyle(e);
      const cuts =
        overflowX !== 'visible' || overflowY !== 'visible' || /strict|content|paint/.test(contain);
      cutting.set(e, cuts && display !== 'inline');
      return cuts && display !== 'inline';
    };
    const around = (e: Element): Element | null => {
      const above = e.parentNode;
      return above instanceof ShadowRoot ? above.host : e.parentElement;
    };
    /** A list scrolls by whole pixels of the screen, so a letter's place differs by up to two. */
    const isWithin = (inner: DOMRect, outer: DOMRect): boolean =>
      inner.left >= outer.left - 2 &&
      inner.right <= outer.right + 2 &&
      inner.top >= outer.top - 2 &&
      inner.bottom <= outer.bottom + 2;
    const texts = function* (from: ParentNode): Generator<Text> {
      for (const node of from.childNodes) {
        if (node instanceof Text && node.data.trim() !== '') yield node;
        if (!(node instanceof HTMLElement) || node.matches('.heard, style, datalist')) continue;
        if (!node.checkVisibility()) continue;
        yield* texts(node);
        if (node.shadowRoot) yield* texts(node.shadowRoot);
      }
    };

    /** Looks at the text of a part; its lines, for the overlaps. */
    const read = (name: string, within: Element): readonly DOMRect[] => {
      const lines: DOMRect[] = [];
      for (const text of texts(within)) {
        const parent = text.parentElement;
        if (parent === null) continue;
        const range = document.createRange();
        range.selectNodeContents(text);
        const box = range.getBoundingClientRect();
        if (box.width === 0) continue;
        // A line of the procedure that is scrolled away is no fault; the current one is checked below.
        const list = parent.closest('.procedures');
        if (list !== null && !isWithin(box, boxOf(list))) continue;
        for (let e: Element | null = parent; e !== null && e !== player; e = around(e)) {
          if (!isCutting(e) || isWithin(box, boxOf(e))) continue;
          fault(`${name} cut off`, text.data);
          break;
        }
        const size = Number.parseFloat(getComputedStyle(parent).fontSize) * parent.currentCSSZoom;
        if (size < innerHeight / 50 - 0.1)
          fault(`${name} too small, ${size.toFixed(1)}`, text.data);
        lines.push(...range.getClientRects());
      }
      return lines;
    };
    /** Rows of text may touch, since a letter rarely fills its line. */
    const overlap = (a: DOMRect, b: DOMRect): boolean =>
      Math.min(a.right, b.right) - Math.max(a.left, b.left) > 2 &&
      Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.3 * Math.min(a.height, b.height);

    /** The current line, or the name of an entered procedure, and the lines before and after it. */
    const follows = (): void => {
      const inside = part('vidno-listing')?.shadowRoot;
      const list = inside?.querySelector('.procedures');
      const now =
        inside?.querySelector<HTMLElement>('.entered h3') ??
        inside?.querySelector<HTMLElement>('[aria-current]');
      if (!list || player.step === 0) return;
      const at = root.querySelector('.at')?.textContent ?? '';
      if (!now) {
        fault('no current line', at);
        return;
      }
      const next = now.matches('h3')
        ? now.nextElementSibling?.firstElementChild
        : now.nextElementSibling;
      for (const line of [now.previousElementSibling, now, next]) {
        if (line && !isWithin(boxOf(line), boxOf(list))) fault('out of sight', line.textContent);
      }
    };

    // Drawing the pixels of the large screen would take most of the time.
    player.style.clipPath = 'inset(100%)';
    let places = '';
    for (step of all) {
      player.moveTo(step);
      await player.updateComplete;
      await frame();
      boxes = new Map();
      const shown = Object.entries(parts).map(([name, selector]) => {
        const element = part(selector);
        if (!element?.checkVisibility()) fault(name, 'is missing');
        return { name, element, box: element === null ? new DOMRect() : boxOf(element) };
      });
      const now = shown
        .map(({ box: { x, y, width, height } }) => [x, y, width, height].map(Math.round).join())
        .join(' ');
      if (places !== '' && places !== now) fault('moved', `${places} to ${now}`);
      places = now;
      for (const { name, element, box } of shown) {
        if (element === null) continue;
        if (!isWithin(box, new DOMRect(0, 0, innerWidth, innerHeight))) fault(name, 'outside');
        if (shown.some((other) => other.name !== name && overlap(box, other.box)))
          fault(name, 'overlaps');
        if (name === 'picture') {
          if (box.width < 0.4 * innerWidth || box.height < 0.6 * innerHeight)
            fault(name, 'is small');
          continue;
        }
        const lines = read(name, element);
        lines.forEach((a, i) => {
          if (lines.slice(i + 1).some((b) => overlap(a, b)))
            fault(`${name} overlaps`, `${a.x} ${a.y}`);
        });
        const end = Math.max(...lines.map(({ bottom }) => bottom));
        if (name === 'state' && (end - box.top) / box.height < 0.75) fault(name, 'is half empty');
        if (name === 'listing' && (end - box.top) / box.height < 0.5) fault(name, 'is half empty');
      }
      follows();
    }
    player.style.clipPath = '';
    return [...faults].map(([said, at]) => `${said} (at ${at})`);
  }, steps);
}
