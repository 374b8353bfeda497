import { jsonInPage } from '../base/markup.js';
import { blockOf } from './lessons.js';
import type { Lesson } from './lessons.js';

/** The content of another page. */
export interface PageContent {
  /** The lessons. Their runs and texts are files of this page, unless `own` has them. */
  readonly lessons: readonly Lesson[];
  /** Files that this page does not contain, by name. */
  readonly own: ReadonlyMap<string, Blob>;
  /** The address at which it opens. */
  readonly address: string;
}

/** Whether the page was opened from disk, so that its address works for nobody else. */
export const isOnDisk = (): boolean => location.protocol === 'file:';

/** The address at which the page opens if its own has no fragment. */
export function embeddedAddress(page: Document): string {
  const block = page.getElementById('vidno-address');
  const address: unknown = block === null ? '' : JSON.parse(block.textContent);
  return typeof address === 'string' ? address : '';
}

/** The content of this page, and the elements that its script has made. */
const replaced = [
  '#vidno-lessons',
  '#vidno-address',
  'script[data-vidno-file]',
  'script[type="module"]',
].join();

const jsonBlock = (id: string, value: unknown): string =>
  `<script type="application/json" id="${id}">${jsonInPage(value)}</script>`;

const fileBlock = (name: string, base64: string): string =>
  `<script type="application/octet-stream" data-vidno-file="${name}">${base64}</script>`;

/** A file in base64, encoded by the browser because the file may be large. */
function base64(file: Blob): Promise<string> {
  const reader = new FileReader();
  return new Promise((resolve, reject) => {
    reader.onload = () => resolve((reader.result as string).replace(/^[^,]*,/, ''));
    reader.onerror = () => reject(reader.error ?? new Error('not read'));
    reader.readAsDataURL(file);
  });
}

/** The text of the page without all that, before and after the blocks of data. */
function shell(page: Document): readonly [string, string] {
  // Nothing in a separate document is executed or loaded.
  const copy = page.implementation.createHTMLDocument().importNode(page.documentElement, true);
  for (const each of copy.querySelectorAll(replaced)) each.remove();
  const app = copy.querySelector('vidno-app');
  for (const { name } of [...(app?.attributes ?? [])]) app?.removeAttribute(name);
  // eslint-disable-next-line no-restricted-syntax -- it is written here, not parsed
  const html = copy.outerHTML;
  const end = html.lastIndexOf('</body>');
  const notes = [...page.childNodes].filter((node) => node instanceof Comment);
  const licences = notes.map(({ data }) => `<!--${data}-->\n`).join('');
  return [`<!doctype html>\n${html.slice(0, end)}`, `${html.slice(end)}\n${licences}`];
}

function filesOf({ lessons }: PageContent): ReadonlySet<string> {
  const names = lessons.flatMap(({ traces, story }) => [
    ...traces.map(({ file }) => file),
    ...(story === undefined ? [] : [story]),
  ]);
  return new Set(names);
}

/** A page like this one that contains only some of its lessons, or what was opened in it. */
export async function pageFile(page: Document, content: PageContent): Promise<Blob> {
  const { lessons, own, address } = content;
  const [before, after] = shell(page);
  const base64Of = async (name: string): Promise<string> => {
    const file = own.get(name);
    return file === undefined ? (blockOf(page, name)?.textContent.trim() ?? '') : base64(file);
  };
  const parts = [before, jsonBlock('vidno-lessons', lessons), jsonBlock('vidno-address', address)];
  for (const name of filesOf(content)) parts.push(fileBlock(name, await base64Of(name)));
  return new Blob([...parts, after], { type: 'text/html' });
}
