import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** The part of the player that messages move and ask. */
export interface Moved {
  readonly step: number;
  readonly first: number;
  readonly last: number;
  moveTo(step: number): void;
}

/** What is shown, as the page tells the one that frames it. */
export interface ShownMessage {
  readonly vidno: 'shown';
  readonly step: number;
  readonly first: number;
  readonly last: number;
}

type Request =
  | { readonly vidno: 'go'; readonly step: number }
  | { readonly vidno: 'next' | 'previous' | 'what' };

/** The request in a message; null if it is none. Other scripts of the surrounding page may send messages of their own. */
export function requestIn(data: unknown): Request | null {
  if (typeof data !== 'object' || data === null) return null;
  const { vidno, step } = data as { readonly vidno?: unknown; readonly step?: unknown };
  if (vidno === 'go') return Number.isInteger(step) ? { vidno, step: step as number } : null;
  return vidno === 'next' || vidno === 'previous' || vidno === 'what' ? { vidno } : null;
}

/** The origin of all files from disk, as a browser states it in a message. */
const ofFiles = ['null', 'file://'];

/**
 * Whether a page of an origin may send messages: one of the page's own origin, a file if the page itself is one, or an origin
 * that the page names in its head.
 */
export function isTrusted(
  origin: string,
  own: Pick<Location, 'protocol' | 'origin'>,
  named: readonly string[],
): boolean {
  if (own.protocol === 'file:') return ofFiles.includes(origin) || named.includes(origin);
  return origin !== 'null' && (origin === own.origin || named.includes(origin));
}

/** The origins in the page's head: <meta name="vidno-origins" content="https://slides.example https://…">. */
const namedIn = (page: Document): readonly string[] =>
  page
    .querySelector<HTMLMetaElement>('meta[name=vidno-origins]')
    ?.content.split(/\s+/u)
    .filter(Boolean) ?? [];

/** Lets the page that frames this one move the run, and tells it each step from its first message on. */
export class Messages implements ReactiveController {
  private sent: ShownMessage | null = null;
  private post: ((message: ShownMessage) => void) | null = null;

  constructor(
    host: ReactiveControllerHost,
    private readonly player: () => Moved | null,
  ) {
    host.addController(this);
  }

  hostConnected(): void {
    window.addEventListener('message', this.onMessage);
  }

  hostDisconnected(): void {
    window.removeEventListener('message', this.onMessage);
  }

  hostUpdated(): void {
    const player = this.player();
    if (player === null || this.post === null) return;
    const { step, first, last } = player;
    const { sent } = this;
    if (sent?.step === step && sent.first === first && sent.last === last) return;
    this.tell(player);
  }

  private tell({ step, first, last }: Moved): void {
    this.sent = { vidno: 'shown', step, first, last };
    this.post?.(this.sent);
  }

  private readonly onMessage = ({ data, origin, source }: MessageEvent<unknown>): void => {
    const isFramed = source === window.parent && source !== window;
    if (!isFramed || !isTrusted(origin, location, namedIn(document))) return;
    const request = requestIn(data);
    const player = this.player();
    if (request === null || player === null) return;
    const to = ofFiles.includes(origin) ? '*' : origin;
    this.post = (message) => window.parent.postMessage(message, to);
    if (request.vidno === 'go') player.moveTo(request.step);
    else if (request.vidno !== 'what') {
      player.moveTo(player.step + (request.vidno === 'next' ? 1 : -1));
    }
    this.tell(player);
  };
}
