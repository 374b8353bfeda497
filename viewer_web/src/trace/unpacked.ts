import { isGzip, toUtf8 } from '../base/file.js';

const pause = (milliseconds: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

/** The bytes of a text in UTF-8, from a file that is plain or gzip. */
export class Unpacked {
  /** Whether compressed data are broken, or end too early. */
  isBroken = false;
  /** The number of bytes of the file read so far. */
  read = 0;
  private reads = 0;
  private reading = false;
  private isLeft = false;

  constructor(private readonly file: Blob) {}

  async *pieces(): AsyncGenerator<Uint8Array> {
    const reader = (await this.bytes()).getReader();
    try {
      for (let piece = await this.next(reader); piece !== null; piece = await this.next(reader)) {
        yield piece;
      }
    } finally {
      this.isLeft = true;
      reader.cancel().catch(() => undefined);
    }
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

  /** A truncated gzip stream fails when closed and discards unread data. This waits until the data are read, or not wanted. */
  private async drained(): Promise<void> {
    let seen = -1;
    while (!this.isLeft && (!this.reading || seen !== this.reads)) {
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
      this.isBroken = true;
      return null;
    } finally {
      this.reading = false;
    }
  }
}
