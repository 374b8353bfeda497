/** Enough of a file to see what it is. */
const peek = 4096;

/** Whether a file is a scene of polygons or of curves, and not a trace, whose first line contains one. */
export async function isScene(file: Blob): Promise<boolean> {
  const start = await file.slice(0, peek).text();
  return (
    /"vidno-(scene|surface)\/1"/u.test(start) &&
    !/^\s*\{\s*"format"\s*:\s*"vidno-trace\/1"/u.test(start)
  );
}
