type Vouch = (address: string) => unknown;
interface Vouching {
  createPolicy(name: string, rules: { createScriptURL: Vouch }): { createScriptURL: Vouch };
}

/** Some policies accept only addresses of scripts from a trusted source. The only one here is the page's own text. */
const { trustedTypes } = globalThis as { readonly trustedTypes?: Vouching };
const vouched = trustedTypes?.createPolicy('vidno-worker', {
  createScriptURL: (address) => address,
});

/** Returns a function that starts workers with a script from the page's own text. */
export function starterOf(code: string): () => Worker {
  // Kept for the next worker: a browser may read the address only after the worker was created.
  const own = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  return () => new Worker((vouched?.createScriptURL(own) ?? own) as string);
}
