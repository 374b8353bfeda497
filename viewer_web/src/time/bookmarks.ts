import { fromBase64, toBase64Url } from '../base/base64.js';

/** A step to return to, with a note of one line. */
export interface Bookmark {
  readonly step: number;
  readonly note: string;
}

/** Sorted by step, at most one per step. */
export type Bookmarks = readonly Bookmark[];

/** Within these limits bookmarks take at most some 4000 characters of a link. */
export const mostBookmarks = 16;
export const longestNote = 60;
const longestWritten = 4096;

/** Characters that would break the line, reverse the surrounding text or be invisible. */
const unfit = /[\p{Cc}\p{Zl}\p{Zp}\p{Cs}\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069\ufeff]+/gu;

/** A note reduced to a line of bounded length, because a link may come from anybody. */
export function cleanNote(note: string): string {
  return note.replace(unfit, ' ').trim().slice(0, longestNote).replace(unfit, '').trim();
}

export function bookmarkAt(bookmarks: Bookmarks, step: number): Bookmark | null {
  return bookmarks.find((bookmark) => bookmark.step === step) ?? null;
}

/** Bookmarks a step with a note. Does nothing beyond the limit. */
export function withBookmark(bookmarks: Bookmarks, step: number, note: string): Bookmarks {
  const others = withoutBookmark(bookmarks, step);
  if (others.length >= mostBookmarks) return bookmarks;
  return [...others, { step, note: cleanNote(note) }].sort((a, b) => a.step - b.step);
}

/** Bookmarks a step; keeps the note that it has. */
export function marked(bookmarks: Bookmarks, step: number): Bookmarks {
  return bookmarkAt(bookmarks, step) === null ? withBookmark(bookmarks, step, '') : bookmarks;
}

export function withoutBookmark(bookmarks: Bookmarks, step: number): Bookmarks {
  return bookmarks.filter((bookmark) => bookmark.step !== step);
}

/** The bookmarks within a run of this length. */
export function bookmarksUpTo(bookmarks: Bookmarks, length: number): Bookmarks {
  return bookmarks.every(({ step }) => step <= length)
    ? bookmarks
    : bookmarks.filter(({ step }) => step <= length);
}

/**
 * The form in a link: one line per step and note, in UTF-8 and base64. In this form Russian takes half as much as with
 * percent encoding.
 */
export function formatBookmarks(bookmarks: Bookmarks): string {
  const lines = bookmarks.map(({ step, note }) => `${step} ${note}`);
  return toBase64Url(new TextEncoder().encode(lines.join('\n')));
}

/** Ignores invalid bookmarks. */
export function parseBookmarks(written: string): Bookmarks {
  return linesIn(written).reduce<Bookmarks>((bookmarks, line) => {
    const [, step, note = ''] = /^(\d{1,9})(?: (.*))?$/s.exec(line) ?? [];
    if (step === undefined) return bookmarks;
    return withBookmark(bookmarks, Number(step), note);
  }, []);
}

function linesIn(written: string): readonly string[] {
  if (written === '' || written.length > longestWritten) return [];
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(fromBase64(written)).split('\n');
  } catch {
    return [];
  }
}
