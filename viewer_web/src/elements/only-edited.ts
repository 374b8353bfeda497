/** A change of the scene is shown by the form and the handles; the rest waits for its run. */
export function isOnlyEdited(changed: ReadonlyMap<PropertyKey, unknown>): boolean {
  return (
    changed.size > 0 && [...changed.keys()].every((key) => /^(editing|link)$/.test(String(key)))
  );
}
