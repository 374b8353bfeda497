import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** What is being typed into a field that shows a value which others change: it stands until it is done with. */
export class Typed implements ReactiveController {
  private text: string | null = null;

  constructor(private readonly host: ReactiveControllerHost) {
    host.addController(this);
  }

  hostDisconnected(): void {
    this.text = null;
  }

  or(value: string): string {
    return this.text ?? value;
  }

  readonly onInput = (event: Event): void => {
    this.text = (event.target as HTMLInputElement).value;
  };

  /** Entered, or left. */
  readonly onEnd = (): void => {
    this.text = null;
    this.host.requestUpdate();
  };
}
