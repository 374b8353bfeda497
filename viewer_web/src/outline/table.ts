type Numbers =
  | Uint8Array<ArrayBuffer>
  | Uint16Array<ArrayBuffer>
  | Uint32Array<ArrayBuffer>
  | Int32Array<ArrayBuffer>;

const some = 64;

function twice<T extends Numbers>(column: T): T {
  const Make = column.constructor as new (length: number) => T;
  const larger = new Make(2 * column.length);
  larger.set(column);
  return larger;
}

/**
 * The nodes of an outline, a row each in the order of their first steps, so that a node stands before all that is in it. A long
 * run has some 100 000 of them: each of their properties is a column.
 */
export class NodeTable {
  first = new Uint32Array(some);
  /** Its last step, those of the nodes in it among them. */
  last = new Uint32Array(some);
  /** The row after it and all nodes in it; 0 while it is open. */
  end = new Uint32Array(some);
  /** The node that it is in; `none` at the top. */
  parent = new Uint32Array(some);
  /** Which of the nodes there it is, from 1, and how many are in itself. */
  place = new Uint32Array(some);
  children = new Uint32Array(some);
  /** From 1 at the top. */
  depth = new Uint16Array(some);
  kind = new Uint8Array(some);
  /** What the course of the run says of it, see `Stretches`; -1 for what is no item. */
  part = new Int32Array(some);
  size = 0;

  /** A further row, all zeros; gives its number. */
  add(): number {
    if (this.size === this.first.length) {
      this.first = twice(this.first);
      this.last = twice(this.last);
      this.end = twice(this.end);
      this.parent = twice(this.parent);
      this.place = twice(this.place);
      this.children = twice(this.children);
      this.depth = twice(this.depth);
      this.kind = twice(this.kind);
      this.part = twice(this.part);
    }
    return this.size++;
  }
}

/** In the place of a node where there is none. */
export const none = 2 ** 32 - 1;
