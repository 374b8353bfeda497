import type { ReactiveController, ReactiveControllerHost } from 'lit';

/**
 * Opens everything that the host hides until requested while the page is being printed, because nothing can be opened on
 * paper.
 */
export class PrintedWhole implements ReactiveController {
  private opened: readonly HTMLDetailsElement[] = [];

  constructor(private readonly host: ReactiveControllerHost & { readonly renderRoot: ParentNode }) {
    host.addController(this);
  }

  hostConnected(): void {
    window.addEventListener('beforeprint', this.open);
    window.addEventListener('afterprint', this.close);
  }

  hostDisconnected(): void {
    window.removeEventListener('beforeprint', this.open);
    window.removeEventListener('afterprint', this.close);
  }

  private readonly open = (): void => {
    this.opened = [
      ...this.host.renderRoot.querySelectorAll<HTMLDetailsElement>('details:not([open])'),
    ];
    for (const details of this.opened) details.open = true;
  };

  private readonly close = (): void => {
    for (const details of this.opened) details.open = false;
    this.opened = [];
  };
}
