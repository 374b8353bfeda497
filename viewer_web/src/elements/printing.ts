import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** Whether the page is being printed. The drawings for paper are made only then. */
export class Printing implements ReactiveController {
  now = false;

  constructor(private readonly host: ReactiveControllerHost) {
    host.addController(this);
  }

  hostConnected(): void {
    window.addEventListener('beforeprint', this.follow);
    window.addEventListener('afterprint', this.follow);
  }

  hostDisconnected(): void {
    window.removeEventListener('beforeprint', this.follow);
    window.removeEventListener('afterprint', this.follow);
  }

  private readonly follow = ({ type }: Event): void => {
    this.now = type === 'beforeprint';
    this.host.requestUpdate();
  };
}
