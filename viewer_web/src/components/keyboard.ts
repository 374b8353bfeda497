/** Whether the element in focus means the key for itself. */
export function takesKey(event: KeyboardEvent): boolean {
  const [target] = event.composedPath();
  if (target instanceof HTMLInputElement) {
    return target.type === 'range' ? !['?', ' ', '+', '-'].includes(event.key) : event.key !== '?';
  }
  if (target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLButtonElement && event.key === ' ';
}
