/** JSON that does not end its block of a page. It is ASCII, since a browser reads a page with other characters more slowly. */
export const jsonInPage = (value: unknown): string =>
  JSON.stringify(value).replace(
    /[<\u0080-\uffff]/g,
    (unit) => `\\u${unit.charCodeAt(0).toString(16).padStart(4, '0')}`,
  );
