/** Saves a file where the browser puts what was downloaded. */
export function download(file: Blob, name: string): void {
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(file);
  anchor.download = name;
  anchor.click();
  URL.revokeObjectURL(anchor.href);
}

/** Words as a part of a file's name. */
export function fileName(...words: readonly string[]): string {
  const parts = words.map((word) => word.replace(/[^\p{L}\p{N}]+/gu, '-').toLowerCase());
  return parts
    .map((part) => part.replace(/^-|-$/g, ''))
    .filter(Boolean)
    .join('.');
}
