type Vouch = (address: string) => unknown;
interface Vouching {
  createPolicy(name: string, rules: { createScriptURL: Vouch }): { createScriptURL: Vouch };
}

/** Where scripts' addresses must be vouched for: the only one is that of the page's own text. */
const { trustedTypes } = globalThis as { readonly trustedTypes?: Vouching };
const vouched = trustedTypes?.createPolicy('vidno-worker', {
  createScriptURL: (address) => address,
});

/** The way to start workers whose script is a text of the page's own. */
export function starterOf(code: string): () => Worker {
  // Kept for the next one: a browser may look it up only after the worker was made.
  const own = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  return () => new Worker((vouched?.createScriptURL(own) ?? own) as string);
}
