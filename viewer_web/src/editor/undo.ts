/** The previous, current and undone values. */
export class Undo<T> {
  private readonly past: T[] = [];
  private future: T[] = [];
  private running: string | null = null;

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  /** The number of changes that can be undone. */
  get depth(): number {
    return this.past.length;
  }

  get canUndo(): boolean {
    return this.depth > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** Successive changes with the same name, such as those of one drag, are undone together. */
  change(value: T, name: string | null = null): void {
    if (value === this.current) return;
    if (name === null || name !== this.running) this.past.push(this.current);
    this.running = name;
    this.current = value;
    this.future = [];
  }

  /** Makes the next change a separate one, whatever its name. */
  settle(): void {
    this.running = null;
  }

  undo(): void {
    const before = this.past.pop();
    if (before === undefined) return;
    this.future.push(this.current);
    this.current = before;
    this.settle();
  }

  redo(): void {
    const after = this.future.pop();
    if (after === undefined) return;
    this.past.push(this.current);
    this.current = after;
    this.settle();
  }
}
