/** What ended the stream of lines before its time. */
export interface Break {
  readonly line: number;
  readonly why: 'gzip' | 'utf8' | 'long';
}

const longestLine = 2 ** 27;

async function isGzip(file: Blob): Promise<boolean> {
  const [first, second] = new Uint8Array(await file.slice(0, 2).arrayBuffer());
  return first === 0x1f && second === 0x8b;
}

const pause = (milliseconds: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

/**
 * The lines of a text, plain or gzip, piece by piece: the whole text never exists as one string.
 * `whole` says whether the lines ended with a newline. A broken stream leaves a `Break`.
 */
export class Lines {
  broken: Break | null = null;
  private rest = '';
  private count = 0;
  private reads = 0;
  private reading = false;

  constructor(private readonly file: Blob) {}

  async *batches(): AsyncGenerator<{ readonly lines: readonly string[]; readonly whole: boolean }> {
    const reader = (await this.bytes()).getReader();
    const decoder = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });
    try {
      for (;;) {
        const chunk = await this.next(reader);
        if (chunk === null) break;
        const lines = this.cut(this.decode(decoder, chunk));
        if (lines.length > 0) yield { lines, whole: true };
        if (this.stopped()) return;
      }
      this.cut(this.decode(decoder));
      if (this.rest !== '') yield { lines: [this.rest], whole: false };
    } finally {
      reader.cancel().catch(() => undefined);
    }
  }

  private async bytes(): Promise<ReadableStream<Uint8Array>> {
    const stream = this.file.stream();
    if (!(await isGzip(this.file))) return stream;
    const patient = new TransformStream<Uint8Array, Uint8Array<ArrayBuffer>>({
      transform: (chunk, out) => {
        out.enqueue(new Uint8Array(chunk));
      },
      flush: () => this.drained(),
    });
    return stream.pipeThrough(patient).pipeThrough(new DecompressionStream('gzip'));
  }

  /** A cut gzip stream fails when closed and throws away what still waits to be read: let it wait. */
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
      this.stop('gzip');
      return null;
    } finally {
      this.reading = false;
    }
  }

  private decode(decoder: TextDecoder, chunk?: Uint8Array): string {
    try {
      return chunk === undefined ? decoder.decode() : decoder.decode(chunk, { stream: true });
    } catch {
      this.stop('utf8');
      return '';
    }
  }

  private cut(piece: string): readonly string[] {
    if (this.rest.length > longestLine) this.stop('long');
    if (!piece.includes('\n')) {
      this.rest += piece;
      return [];
    }
    const lines = (this.rest + piece).split('\n');
    this.rest = lines.pop() ?? '';
    this.count += lines.length;
    return lines;
  }

  private stop(why: Break['why']): void {
    this.broken ??= { line: this.count + 1, why };
  }

  private stopped(): boolean {
    return this.broken !== null;
  }
}
