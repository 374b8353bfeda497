/**
 * Copies bytes into two buffers in turn, because new memory takes several times as long to fill. A copy lasts until the copy
 * after the next one. If that takes its memory, it is empty from then on.
 */
export class TwoBuffers {
  private older = new ArrayBuffer(0);
  private newer = new ArrayBuffer(0);

  copy(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
    const { length } = bytes;
    const { older } = this;
    const next =
      older.byteLength < length
        ? new ArrayBuffer(2 * length)
        : structuredClone(older, { transfer: [older] }); // moves the memory, and empties the old copy
    this.older = this.newer;
    this.newer = next;
    const copy = new Uint8Array(next, 0, length);
    copy.set(bytes);
    return copy;
  }
}
