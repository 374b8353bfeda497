import { textStream } from '../base/file.js';

/** The kind of a file. The library reads scenes, of polygons or of curves, and reports their errors. */
export type FileKind = 'scene' | 'failure' | 'chart' | 'mesh' | 'trace';

/** The length of text that suffices to recognize a file. */
const peek = 2 ** 16;

/** By the name of the format. The code that reads the file reports a version it does not know. */
const kinds: ReadonlyMap<string, FileKind> = new Map([
  ['vidno-scene', 'scene'],
  ['vidno-surface', 'scene'],
  ['vidno-failure', 'failure'],
  ['vidno-chart', 'chart'],
  ['vidno-trace', 'trace'],
]);

/** Keys that identify the kind of a file without a format; `document_format` of the program has the same. */
const kindByKey: ReadonlyMap<string, FileKind> = new Map([
  ['polygons', 'scene'],
  ['curves', 'scene'],
  ['function', 'scene'],
  ['fails', 'failure'],
]);

const tokens = /"(?:[^"\\]|\\.)*"|[{}[\]:]/gsu;

/** The kind by the members of the outermost object, up to where the text ends or is not JSON. */
function saidIn(start: string): FileKind | null {
  let depth = 0;
  let key = '';
  let last = '';
  for (const [token] of start.matchAll(tokens)) {
    if (depth === 1 && token === ':') {
      key = last.slice(1, -1);
      const kind = kindByKey.get(key);
      if (kind !== undefined) return kind;
    } else if (depth === 1 && key === 'format' && token.startsWith('"')) {
      return kinds.get(token.slice(1, -1).split('/')[0] ?? '') ?? null;
    } else {
      if (token === ':') continue;
      if (token === '{' || token === '[') depth++;
      if (token === '}' || token === ']') depth--;
      if (depth === 1) key = '';
    }
    last = token;
  }
  return null;
}

function isObject(text: string): boolean {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null && !Array.isArray(value);
  } catch {
    return false;
  }
}

/** How the meshes begin that the library reads: PLY, STL, OFF and, after comments, OBJ. */
const meshes = [
  /^ply\s/u,
  /^solid\b[^\n]*\s+facet\b/u,
  /^(?:ST)?C?N?4?n?OFF\s/u,
  /^(?:#[^\n]*\s+|(?:mtllib|o|g|s|usemtl)\s[^\n]*\s+)*v\s+[-+.\d]/u,
];

/**
 * The kind of a text by its beginning. A text without identification is a trace if its first line could belong to one, or
 * if it is not an object at all.
 */
export function kindOf(start: string): FileKind {
  const said = saidIn(start);
  if (said !== null) return said;
  const text = start.trimStart();
  const [first = ''] = text.split('\n');
  if (meshes.some((beginning) => beginning.test(text))) return 'mesh';
  return text.startsWith('{') && !isObject(first) ? 'scene' : 'trace';
}

export async function kindOfFile(file: Blob): Promise<FileKind> {
  return kindOf(await startOf(file));
}

/** Whether a file is a mesh, by its name. A binary one is recognized by that alone. */
export const isMesh = (name: string): boolean => /\.(?:obj|off|ply|stl)$/iu.test(name);

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
    // Broken gzip is reported when the whole file is read.
  }
  reader.cancel().catch(() => undefined);
  return start.slice(0, peek);
}
