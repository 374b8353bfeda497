const prefix = 'vidno.';
const meanwhile = new Map<string, string>();

/**
 * What the page keeps from one visit to the next: sizes of panels, and what was offered once. Where the browser keeps nothing,
 * as it may for a page on a disk, it lasts as long as the page is open.
 */
export const memory = {
  get(key: string): string | null {
    try {
      return localStorage.getItem(prefix + key) ?? meanwhile.get(key) ?? null;
    } catch {
      return meanwhile.get(key) ?? null;
    }
  },

  set(key: string, value: string): void {
    meanwhile.set(key, value);
    try {
      localStorage.setItem(prefix + key, value);
    } catch {
      // It is kept meanwhile.
    }
  },
};
