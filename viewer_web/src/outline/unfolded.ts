import type { Outline } from './outline.js';
import { none } from './table.js';

/**
 * Which nodes of an outline are unfolded, and so which rows there are: those that the reader has unfolded, and the way to the
 * step that is shown, which folds again behind it unless the reader does something with the tree.
 */
export class Unfolded {
  private rows = new Uint32Array(256);
  private count = 0;
  private readonly byReader = new Set<number>();
  /** What the reader has folded stays so, though the step be in it. */
  private readonly folded = new Set<number>();
  private way: readonly number[] = [];
  /** The size of the outline for which the rows were made; -1 if others are due. */
  private madeFor = -1;
  private turn = 0;

  constructor(readonly outline: Outline) {}

  /** Changes whenever the rows do. */
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

  /** The row of a node, or of the innermost one that it is in and that has a row; -1 for no node. */
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

  /** The step has come to this node: what it is in is unfolded, and what it has left is folded. */
  follow(node: number): void {
    const [at, ...around] = this.outline.wayUp(node);
    const way = at !== undefined && this.way.includes(at) ? [at, ...around] : around;
    if (way.length === this.way.length && way.every((each, i) => each === this.way[i])) return;
    this.way = way;
    this.madeFor = -1;
  }

  /** What is unfolded now stays so. */
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

  /** Unfolds all that a node is in. */
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

  /** The row of just this node, or -1. */
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
