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
