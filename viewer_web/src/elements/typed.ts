import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** The text being typed into a field whose value others change. It stays until the reader has finished. */
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

  /** On Enter, or when the field loses the focus. */
  readonly onEnd = (): void => {
    this.text = null;
    this.host.requestUpdate();
  };
}
