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
 * The nodes of an outline, one row each, in the order of their first steps, so that a node comes before its descendants. A
 * long run has some 100 000 nodes, so each property is a column.
 */
export class NodeTable {
  first = new Uint32Array(some);
  /** Its last step, including those of its descendants. */
  last = new Uint32Array(some);
  /** The row after it and its descendants; 0 while it is open. */
  end = new Uint32Array(some);
  /** Its parent; `none` at the top. */
  parent = new Uint32Array(some);
  /** Its index among its siblings, from 1, and the number of its children. */
  place = new Uint32Array(some);
  children = new Uint32Array(some);
  /** Its depth, 1 at the top. */
  depth = new Uint16Array(some);
  kind = new Uint8Array(some);
  /** The value from the run's course, see `Stretches`; -1 if it is not an item. */
  part = new Int32Array(some);
  size = 0;

  /** Adds a row of zeros and returns its number. */
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

/** Stands for no node. */
export const none = 2 ** 32 - 1;
