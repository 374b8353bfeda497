/** Bytes in base64, of either alphabet. Throws where the text is none. */
export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const letters = text.replaceAll('-', '+').replaceAll('_', '/');
  return Uint8Array.from(atob(letters), (byte) => byte.charCodeAt(0));
}

export function toBase64(bytes: Uint8Array): string {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

/** Bytes in the alphabet of base64 that an address leaves as it is. */
export function toBase64Url(bytes: Uint8Array): string {
  return toBase64(bytes).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The file that a block of data of the page holds. */
export function fileIn(block: Element): Blob {
  return new Blob([fromBase64(block.textContent.trim())]);
}
