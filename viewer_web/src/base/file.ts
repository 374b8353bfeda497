/** The text in a stream of bytes. Throws a RangeError if there are more bytes than the limit. */
export async function boundedText(
  stream: ReadableStream<Uint8Array>,
  most: number,
): Promise<string> {
  const reader = stream.getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let length = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value as Uint8Array<ArrayBuffer>);
    length += part.value.length;
    if (length > most) throw new RangeError('too long a text');
  }
  return new Blob(parts).text();
}

/** The longest text that is read: a longer one would only block the page. */
const longest = 2 ** 28;

export async function isGzip(file: Blob): Promise<boolean> {
  const [first, second] = new Uint8Array(await file.slice(0, 2).arrayBuffer());
  return first === 0x1f && second === 0x8b;
}

type Bytes = Uint8Array<ArrayBuffer>;

/** The encoding that the byte order mark at the beginning of a text states, and the length of the mark. */
function markOf([first, second, third]: Bytes): readonly [encoding: string, length: number] {
  if (first === 0xef && second === 0xbb && third === 0xbf) return ['utf-8', 3];
  if (first === 0xff && second === 0xfe) return ['utf-16le', 2];
  if (first === 0xfe && second === 0xff) return ['utf-16be', 2];
  return ['utf-8', 0];
}

/** Converts the encodings of text editors, UTF-8 or UTF-16 with a byte order mark, to UTF-8 without one. */
export function toUtf8(): TransformStream<Bytes, Bytes> {
  let head: Bytes | null = new Uint8Array(0);
  let decoder: TextDecoder | null = null;
  const encoder = new TextEncoder();
  const put = (bytes: Bytes, out: TransformStreamDefaultController<Bytes>): void => {
    const text = decoder === null ? bytes : encoder.encode(decoder.decode(bytes, { stream: true }));
    if (text.length > 0) out.enqueue(text);
  };
  const begin = (bytes: Bytes, out: TransformStreamDefaultController<Bytes>): void => {
    const [encoding, length] = markOf(bytes);
    if (encoding !== 'utf-8') decoder = new TextDecoder(encoding);
    head = null;
    put(bytes.subarray(length), out);
  };
  return new TransformStream({
    transform: (chunk, out) => {
      if (head === null) put(chunk, out);
      else {
        head = joined(head, chunk);
        if (head.length >= 3) begin(head, out);
      }
    },
    flush: (out) => {
      if (head !== null) begin(head, out);
      if (decoder !== null) out.enqueue(encoder.encode(decoder.decode()));
    },
  });
}

function joined(one: Bytes, other: Bytes): Bytes {
  const both = new Uint8Array(one.length + other.length);
  both.set(one);
  both.set(other, one.length);
  return both;
}

/** The text of a file, plain or gzip, as UTF-8. */
export async function textStream(file: Blob): Promise<ReadableStream<Uint8Array>> {
  const stream = file.stream();
  const plain = (await isGzip(file))
    ? stream.pipeThrough<Bytes>(new DecompressionStream('gzip'))
    : stream;
  return plain.pipeThrough(toUtf8());
}

/** Throws if the file is broken gzip, or its text is too long. */
export async function textOf(file: Blob): Promise<string> {
  return boundedText(await textStream(file), longest);
}

/** Saves a file in the browser's folder of downloads. */
export function download(file: Blob, name: string): void {
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(file);
  anchor.download = name;
  anchor.click();
  URL.revokeObjectURL(anchor.href);
}

/** Words joined into a part of a file name. */
export function fileName(...words: readonly string[]): string {
  const parts = words.map((word) => word.replace(/[^\p{L}\p{N}]+/gu, '-').toLowerCase());
  return parts
    .map((part) => part.replace(/^-|-$/g, ''))
    .filter(Boolean)
    .join('.');
}
