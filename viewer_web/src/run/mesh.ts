/**
 * A request for the scene of a mesh, the first file, which may name others of them, such as libraries of colours;
 * `live.cpp` of the library documents it.
 */
export async function meshRequest(files: readonly File[]): Promise<Uint8Array<ArrayBuffer>> {
  const given = files.map(({ name, size }) => ({ name, size }));
  const request = new Blob([`${JSON.stringify({ files: given })}\n`, ...files]);
  return new Uint8Array(await request.arrayBuffer());
}
