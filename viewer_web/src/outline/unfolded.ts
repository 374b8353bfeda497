import type { Outline } from './outline.js';
import { none } from './table.js';

/**
 * The unfolded nodes of an outline, and so its rows. These are the nodes that the reader has unfolded, and the ancestors of
 * the current step. The latter fold again when the step leaves them, unless the reader acts on the tree.
 */
export class Unfolded {
  private rows = new Uint32Array(256);
  private count = 0;
  private readonly byReader = new Set<number>();
  /** The nodes that the reader has folded. They stay folded even if the step is in them. */
  private readonly folded = new Set<number>();
  private way: readonly number[] = [];
  /** The size of the outline for which the rows were made; -1 if they are outdated. */
  private madeFor = -1;
  private turn = 0;

  constructor(readonly outline: Outline) {}

  /** A number that changes whenever the rows do. */
  get version(): number {
    this.make();
    return this.turn;
  }

  get length(): number {
    this.make();
    return this.count;
  }

  nodeAt(row: number): number {
    this.make();
    return row >= 0 && row < this.count ? (this.rows[row] ?? none) : none;
  }

  /** The row of a node, or of its innermost ancestor that has a row; -1 for no node. */
  rowOf(node: number): number {
    this.make();
    for (const at of this.outline.wayUp(node)) {
      const row = this.search(at);
      if (row >= 0) return row;
    }
    return -1;
  }

  isUnfolded(node: number): boolean {
    return !this.folded.has(node) && (this.byReader.has(node) || this.way.includes(node));
  }

  /** Follows the step to a node: unfolds its ancestors, and folds those of the previous node. */
  follow(node: number): void {
    const [at, ...around] = this.outline.wayUp(node);
    const way = at !== undefined && this.way.includes(at) ? [at, ...around] : around;
    if (way.length === this.way.length && way.every((each, i) => each === this.way[i])) return;
    this.way = way;
    this.madeFor = -1;
  }

  /** Keeps unfolded what is unfolded now. */
  keep(): void {
    for (const node of this.way) this.byReader.add(node);
  }

  unfold(node: number): void {
    this.keep();
    this.byReader.add(node);
    this.folded.delete(node);
    this.madeFor = -1;
  }

  fold(node: number): void {
    this.keep();
    this.byReader.delete(node);
    this.folded.add(node);
    this.madeFor = -1;
  }

  /** Unfolds all ancestors of a node. */
  reveal(node: number): void {
    const [, ...around] = this.outline.wayUp(node);
    for (const each of around) this.unfold(each);
  }

  private make(): void {
    const { outline } = this;
    if (this.madeFor === outline.size) return;
    this.madeFor = outline.size;
    this.turn++;
    this.count = 0;
    for (let node = 0; node < outline.size;) {
      if (this.count === this.rows.length) {
        const larger = new Uint32Array(2 * this.count);
        larger.set(this.rows);
        this.rows = larger;
      }
      this.rows[this.count++] = node;
      node = this.isUnfolded(node) ? node + 1 : outline.endOf(node);
    }
  }

  /** The row of exactly this node, or -1. */
  private search(node: number): number {
    let from = 0;
    let end = this.count;
    while (from < end) {
      const middle = (from + end) >> 1;
      if ((this.rows[middle] ?? 0) < node) from = middle + 1;
      else end = middle;
    }
    return from < this.count && this.rows[from] === node ? from : -1;
  }
}
