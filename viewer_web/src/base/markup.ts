const references: Readonly<Record<string, string>> = {
  '&': '&amp;',
  '<': '&lt;',
  '>': '&gt;',
  '"': '&quot;',
};

/** Text without the characters that XML cannot represent. */
export function writable(text: string): string {
  return text.replace(
    /[^\t\n\r\u{20}-\u{d7ff}\u{e000}-\u{fffd}\u{10000}-\u{10ffff}]/gu,
    '\u{fffd}',
  );
}

/** Text with all markup characters escaped. */
export function escaped(text: string): string {
  return writable(text).replace(/[&<>"]/g, (character) => references[character] ?? '');
}

/** An element with its attributes and content that is already escaped. */
export function element(
  name: string,
  attributes: Iterable<readonly [string, string | number]>,
  content = '',
): string {
  const written = [...attributes].map(([key, value]) => ` ${key}="${escaped(String(value))}"`);
  return `<${name}${written.join('')}${content === '' ? '/>' : `>${content}</${name}>`}\n`;
}

/** JSON that does not end its block of a page. It is ASCII, since a browser reads a page with other characters more slowly. */
export const jsonInPage = (value: unknown): string =>
  JSON.stringify(value).replace(
    /[<\u0080-\uffff]/g,
    (unit) => `\\u${unit.charCodeAt(0).toString(16).padStart(4, '0')}`,
  );
