/** The SVG drawings of a lesson, as addresses that images can show. */
export class Drawings {
  private readonly addresses = new Map<string, string>();

  addressOf(svg: string): string {
    const address =
      this.addresses.get(svg) ?? URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    this.addresses.set(svg, address);
    return address;
  }

  /** Releases the addresses of drawings that are no longer shown. */
  forget(): void {
    for (const address of this.addresses.values()) URL.revokeObjectURL(address);
    this.addresses.clear();
  }
}
