/** Whether only the scene was changed: the form and the handles show that, and the rest waits for the run. */
export function isOnlyEdited(changed: ReadonlyMap<PropertyKey, unknown>): boolean {
  return (
    changed.size > 0 && [...changed.keys()].every((key) => /^(editing|link)$/.test(String(key)))
  );
}
