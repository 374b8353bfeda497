import { fromBase64, toBase64Url } from '../base/base64.js';
import { boundedText } from '../base/file.js';
import { isEdition } from '../trace/editions.js';
import { details, eventsOf } from '../trace/events.js';
import type { Detail, Method } from '../trace/events.js';
import { runnable, usual } from './options.js';
import type { Options } from './options.js';

/** What an address names as its trace if it cannot hold what it was made from: a file of the reader's own, or a large scene. */
export const unheld = 'unheld';

/** The longest text in an address: some programs truncate longer addresses. */
const longestPacked = 16_000;
/** A few bytes may unpack to very many. */
const longestText = 1_000_000;

function through(bytes: Blob, stream: GenericTransformStream): ReadableStream<Uint8Array> {
  return bytes.stream().pipeThrough<Uint8Array>(stream);
}

/** A text packed into characters of an address; null if it is too long for one. */
export async function packed(text: string): Promise<string | null> {
  const stream = through(new Blob([text]), new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  if (bytes.length * 4 > longestPacked * 3) return null;
  return toBase64Url(bytes);
}

/** The unpacked text. Throws if the characters are not a packed text, or it is too long. */
export async function unpacked(letters: string): Promise<string> {
  const bytes = new Blob([fromBase64(letters)]);
  return boundedText(through(bytes, new DecompressionStream('deflate-raw')), longestText);
}

/** The settings of a run as an address has them: "warnock.corrected.double.signs", possibly with ".check". */
export function wordOf({ method, edition, kernel, detail, check }: Options): string {
  return [method, edition, kernel, detail, ...(check ? ['check'] : [])].join('.');
}

/** Missing or unknown parts get the usual values. */
export function optionsOf(word: string): Options {
  const [method = '', edition = '', kernel = usual.kernel, detail = '', check] = word.split('.');
  return runnable({
    method: Object.hasOwn(eventsOf, method) ? (method as Method) : usual.method,
    edition: isEdition(edition) ? edition : usual.edition,
    kernel,
    detail: details.includes(detail as Detail) ? (detail as Detail) : usual.detail,
    check: check === 'check',
  });
}
