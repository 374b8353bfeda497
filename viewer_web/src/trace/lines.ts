import { isGzip, toUtf8 } from '../base/text-file.js';

/** Why a stream of bytes ended early. */
export type Break = 'gzip' | 'long';

const newline = 10;
const longestLine = 2 ** 27;
/** The size of the first block, small so that something is shown soon. Blocks grow until they are large. */
const smallest = 2 ** 16;
const largest = 2 ** 20;

const pause = (milliseconds: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

/**
 * The lines of a text, plain or gzip, in blocks of UTF-8. Each block has whole lines, except that the last line may be cut.
 */
export class Lines {
  broken: Break | null = null;
  /** The number of bytes of the file read so far. */
  read = 0;
  private buffer = new Uint8Array(smallest);
  private used = 0;
  private reads = 0;
  private reading = false;

  constructor(private readonly file: Blob) {}

  /** The blocks, none empty, each in a separate buffer that may be transferred. */
  async *blocks(): AsyncGenerator<Uint8Array<ArrayBuffer>> {
    const reader = (await this.bytes()).getReader();
    try {
      for (;;) {
        const chunk = await this.next(reader);
        if (chunk === null) break;
        yield* this.put(chunk);
        if (this.broken !== null) return;
      }
      const block = this.cut(smallest);
      if (block.length > 0) yield block;
      if (this.used > 0) yield this.buffer.subarray(0, this.used);
    } finally {
      reader.cancel().catch(() => undefined);
    }
  }

  private *put(chunk: Uint8Array): Generator<Uint8Array<ArrayBuffer>> {
    for (let from = 0; from < chunk.length;) {
      const piece = chunk.subarray(from, from + this.buffer.length - this.used);
      this.buffer.set(piece, this.used);
      this.used += piece.length;
      from += piece.length;
      if (this.used < this.buffer.length) return;
      const next = Math.min(largest, 2 * this.buffer.length);
      const block = this.cut(next);
      if (block.length > 0) yield block;
      else this.grow();
      if (this.broken !== null) return;
    }
  }

  /** The whole lines so far; the rest moves to another buffer. */
  private cut(size: number): Uint8Array<ArrayBuffer> {
    const { buffer } = this;
    const end = this.used === 0 ? 0 : buffer.lastIndexOf(newline, this.used - 1) + 1;
    if (end > 0) {
      const rest = buffer.subarray(end, this.used);
      this.buffer = new Uint8Array(Math.max(size, 2 * rest.length));
      this.buffer.set(rest);
      this.used = rest.length;
    }
    return buffer.subarray(0, end);
  }

  /** Grows the buffer for a line longer than it. */
  private grow(): void {
    const { buffer } = this;
    if (this.used > longestLine) {
      this.broken = 'long';
      return;
    }
    this.buffer = new Uint8Array(2 * buffer.length);
    this.buffer.set(buffer);
  }

  private async bytes(): Promise<ReadableStream<Uint8Array>> {
    const counted = new TransformStream<Uint8Array, Uint8Array<ArrayBuffer>>({
      transform: (chunk, out) => {
        this.read += chunk.length;
        out.enqueue(new Uint8Array(chunk));
      },
      flush: () => this.drained(),
    });
    const stream = this.file.stream().pipeThrough(counted);
    const plain = (await isGzip(this.file))
      ? stream.pipeThrough<Uint8Array<ArrayBuffer>>(new DecompressionStream('gzip'))
      : stream;
    return plain.pipeThrough(toUtf8());
  }

  /** A truncated gzip stream fails when closed and discards unread data. This waits until the data are read. */
  private async drained(): Promise<void> {
    let seen = -1;
    while (!this.reading || seen !== this.reads) {
      seen = this.reads;
      await pause(5);
    }
  }

  private async next(reader: ReadableStreamDefaultReader<Uint8Array>): Promise<Uint8Array | null> {
    this.reads++;
    this.reading = true;
    try {
      const { done, value } = await reader.read();
      return done ? null : value;
    } catch {
      this.broken = 'gzip';
      return null;
    } finally {
      this.reading = false;
    }
  }
}
