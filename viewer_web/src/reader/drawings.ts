/** The drawings of a lesson as addresses that images can show. */
export class Drawings {
  private readonly addresses = new Map<string, string>();

  constructor(private readonly files: ReadonlyMap<string, string>) {}

  addressOf(file: string): string | null {
    const text = this.files.get(file);
    if (text === undefined) return null;
    const address =
      this.addresses.get(file) ?? URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' }));
    this.addresses.set(file, address);
    return address;
  }

  /** They are not shown any more. */
  forget(): void {
    for (const address of this.addresses.values()) URL.revokeObjectURL(address);
    this.addresses.clear();
  }
}
