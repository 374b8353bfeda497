/** Saves a file in the browser's folder of downloads. */
export function download(file: Blob, name: string): void {
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(file);
  anchor.download = name;
  anchor.click();
  URL.revokeObjectURL(anchor.href);
}

/** Words joined into a part of a file name. */
export function fileName(...words: readonly string[]): string {
  const parts = words.map((word) => word.replace(/[^\p{L}\p{N}]+/gu, '-').toLowerCase());
  return parts
    .map((part) => part.replace(/^-|-$/g, ''))
    .filter(Boolean)
    .join('.');
}
