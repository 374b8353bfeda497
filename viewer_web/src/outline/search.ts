import { algorithmOf } from '../algorithm/algorithm.js';
import { Mentions } from './mentions.js';
import type { Outline } from './outline.js';
import type { Meaning, Term } from './query.js';
import { none } from './table.js';

const atOnce = 512;

/** One reading of a query: a meaning for each of its terms. */
type Reading = readonly Meaning[];

/** All readings of a query. */
function readingsOf(terms: readonly Term[]): readonly Reading[] {
  return terms.reduce<readonly Reading[]>(
    (all, { meanings }) => all.flatMap((some) => meanings.map((one) => [...some, one])),
    terms.length === 0 ? [] : [[]],
  );
}

const mentions = new WeakMap<Outline, Mentions>();

function mentionsIn(outline: Outline): Mentions {
  const known = mentions.get(outline) ?? new Mentions(outline.trace);
  mentions.set(outline, known);
  return known;
}

/**
 * Searches the outline of a whole run for the nodes that a query means: calls if it names a procedure, or else parts if it
 * names one, or else current items. The other terms are conditions on these nodes and their ancestors.
 */
export class Search {
  private readonly readings: readonly Reading[];
  private mentions: Mentions | null = null;
  private readonly found: number[] = [];
  private at = 0;
  /** For each set of polygons, which of the current nodes have a step that names one of them. */
  private readonly naming = new Map<ReadonlySet<number>, Uint8Array>();
  private readonly numbers = new Map<number, number | null>();

  constructor(
    private readonly outline: Outline,
    readonly terms: readonly Term[],
  ) {
    this.readings = readingsOf(terms);
  }

  /** The nodes in order. */
  get hits(): readonly number[] {
    return this.found;
  }

  get complete(): boolean {
    return this.readings.length === 0 || this.at >= this.outline.size;
  }

  /** Continues for about this time. Returns whether the whole outline was searched. */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    if (!this.complete && !this.readMentions(milliseconds)) return false;
    do this.readSome();
    while (!this.complete && performance.now() < end);
    return this.complete;
  }

  /** The names of polygons are read only for queries about polygons. */
  private readMentions(milliseconds: number): boolean {
    if (!this.readings.flat().some(({ facet }) => facet === 'polygon')) return true;
    this.mentions ??= mentionsIn(this.outline);
    return this.mentions.read(milliseconds);
  }

  private readSome(): void {
    const stop = this.complete ? this.at : Math.min(this.at + atOnce, this.outline.size);
    for (; this.at < stop; this.at++) {
      if (this.readings.some((reading) => this.isHit(this.at, reading))) this.found.push(this.at);
    }
  }

  private isHit(node: number, reading: Reading): boolean {
    const { outline } = this;
    const names = (facet: Meaning['facet']): boolean =>
      reading.some((meaning) => meaning.facet === facet);
    const what = outline.isItem(node) ? 'item' : outline.isPart(node) ? 'part' : 'procedure';
    const wanted = names('procedure') ? 'procedure' : names('row') ? 'part' : 'item';
    return what === wanted && reading.every((meaning) => this.isMeant(node, meaning));
  }

  private isMeant(node: number, meaning: Meaning): boolean {
    const { outline } = this;
    switch (meaning.facet) {
      case 'procedure': {
        const kind = outline.kindOf(node);
        return kind !== 'item' && kind !== 'part' && meaning.values.has(kind);
      }
      case 'row': {
        const number = this.numberOf(node);
        return number !== null && meaning.values.has(number);
      }
      case 'polygon':
        return this.concerns(node, meaning.values);
      case 'case':
      case 'curve': {
        const item = outline.itemOf(node);
        return item !== none && meaning.values.has(outline.nodes.part[item] ?? -1);
      }
    }
  }

  /**
   * Whether a call's result names a polygon. For other nodes: whether the current item is that polygon, or has a step that
   * names it.
   */
  private concerns(node: number, polygons: ReadonlySet<number>): boolean {
    const { outline, mentions: named } = this;
    const own = outline.isItem(node) ? -1 : (named?.at(outline.lastOf(node)) ?? -1);
    if (!outline.isPart(node) && own >= 0) return polygons.has(own);
    const item = outline.itemOf(node);
    if (item === none) return false;
    const isOfPolygons = algorithmOf(outline.trace.header).lanes.first === 'polygons';
    if (isOfPolygons && polygons.has(outline.nodes.part[item] ?? -1)) return true;
    return this.namingIn(polygons)[item] === 1;
  }

  private namingIn(polygons: ReadonlySet<number>): Uint8Array {
    const known = this.naming.get(polygons);
    if (known !== undefined) return known;
    const { outline } = this;
    const found = new Uint8Array(outline.size);
    this.naming.set(polygons, found);
    let item = none;
    let next = 0;
    const { first } = outline.nodes;
    const { length } = outline.trace.timeline;
    for (let step = 1; step <= length; step++) {
      for (; next < outline.size && (first[next] ?? 0) <= step; next++) {
        if (outline.isItem(next) || outline.nodes.depth[next] === 1) {
          item = outline.isItem(next) ? next : none;
        }
      }
      const place = this.mentions?.at(step) ?? -1;
      if (place >= 0 && item !== none && polygons.has(place)) found[item] = 1;
    }
    return found;
  }

  /** The number of the part at or above a node. */
  private numberOf(node: number): number | null {
    const { outline, numbers } = this;
    for (const at of outline.wayUp(node)) {
      if (!outline.isPart(at)) continue;
      const known = numbers.get(at);
      if (known !== undefined) return known;
      const { header, timeline } = outline.trace;
      const event = timeline.event(outline.nodes.first[at] ?? 0);
      const number = (event && algorithmOf(header).outline.numberOf?.(event)) ?? null;
      numbers.set(at, number);
      return number;
    }
    return null;
  }
}
