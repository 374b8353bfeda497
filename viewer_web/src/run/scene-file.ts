import { textStream } from '../base/text-file.js';

/** Enough of a text to see what it is. */
const peek = 4096;

/** Whether a file is a scene of polygons or of curves, and not a trace, whose first line contains one. */
export async function isScene(file: Blob): Promise<boolean> {
  const start = await startOf(file);
  return (
    /"vidno-(scene|surface)\/1"/u.test(start) &&
    !/^\s*\{\s*"format"\s*:\s*"vidno-trace\/1"/u.test(start)
  );
}

/** The beginning of its text, as far as it can be read. */
async function startOf(file: Blob): Promise<string> {
  const reader = (await textStream(file)).getReader();
  const decoder = new TextDecoder();
  let start = '';
  try {
    while (start.length < peek) {
      const { done, value } = await reader.read();
      if (done) break;
      start += decoder.decode(value, { stream: true });
    }
  } catch {
    // Broken gzip: whoever reads the whole file says so.
  }
  reader.cancel().catch(() => undefined);
  return start.slice(0, peek);
}
