const { fromBase64: decode = inOlderBrowsers } = Uint8Array as {
  readonly fromBase64?: (letters: string) => Uint8Array<ArrayBuffer>;
};

function inOlderBrowsers(letters: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(letters), (byte) => byte.charCodeAt(0));
}

/** The bytes of a text in base64, in either alphabet. Throws if the text is invalid. */
export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  return decode(text.replaceAll('-', '+').replaceAll('_', '/'));
}

export function toBase64(bytes: Uint8Array): string {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

/** Bytes in the alphabet of base64 whose characters an address does not escape. */
export function toBase64Url(bytes: Uint8Array): string {
  return toBase64(bytes).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The file in a block of data of the page. */
export function fileIn(block: Element): Blob {
  return new Blob([fromBase64(block.textContent.trim())]);
}
