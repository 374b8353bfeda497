/** The text that a stream of bytes holds. Throws a RangeError where it has more than so many bytes. */
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
