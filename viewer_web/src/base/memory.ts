const prefix = 'vidno.';
const meanwhile = new Map<string, string>();

/**
 * What the page remembers between visits: the sizes of panels, and which offers were made. Where the browser stores
 * nothing, as it may for a page from disk, this lasts as long as the page is open.
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
      // The value is still kept in this page.
    }
  },
};
