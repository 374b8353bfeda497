import type { ReactiveController, ReactiveControllerHost } from 'lit';
import { parseAddress } from '../reader/address.js';
import type { DiscardElement } from '../editor/discard.js';
import type { TimedElement } from '../player/timed.js';
import type { Place } from './session.js';
import { addressNow, addressOf } from './sharing.js';
import type { Shared } from './sharing.js';
import { Trail, isJump } from './trail.js';

/** A place in a trace of the reader's own. */
export type PlaceInFile = Pick<Place, 'step' | 'pixel'>;

/** What the browser's history keeps beside an address that cannot hold it. */
type Kept =
  /** The number of an opened file. */
  | (PlaceInFile & { readonly file: number })
  /** The scene of the address has unsaved changes. */
  | { readonly isUnsaved: true };

/** A run, or two beside each other, at a step. */
export interface Moving {
  readonly place: { readonly step: number };
  move(to: { readonly step: number }): void;
}

/** The parts of the page that navigation needs. */
export interface Travelled extends Shared, ReactiveControllerHost {
  readonly discard: DiscardElement;
  followAddress(): void;
  /** Opens a file that was opened before. */
  reopen(file: File, place: PlaceInFile): void;
}

/** Navigation away from what is shown. Each move can be undone, and none discards edits without asking. */
export class Navigation implements ReactiveController {
  private readonly trail = new Trail(
    () => addressOf(this.host),
    () => this.kept(),
  );
  /** The files opened so far, by their numbers. */
  private readonly files: File[] = [];
  private visits = 0;

  constructor(private readonly host: Travelled) {
    host.addController(this);
  }

  hostConnected(): void {
    window.addEventListener('hashchange', this.onAddress);
    window.addEventListener('popstate', this.onPlace);
    window.addEventListener('beforeunload', this.onUnload);
  }

  hostDisconnected(): void {
    window.removeEventListener('hashchange', this.onAddress);
    window.removeEventListener('popstate', this.onPlace);
    window.removeEventListener('beforeunload', this.onUnload);
  }

  /** Writes the address after a change. */
  write(): void {
    this.trail.write();
  }

  /** Records the address before something else is shown, so that *Back* returns here. */
  leave(): void {
    // In a frame the browser's history belongs to the surrounding page.
    if (!this.host.setup.setting.embed) this.trail.leave(addressNow(this.host));
  }

  /** Runs an action that replaces the scene. If the scene was changed, the reader must agree first. */
  async replace(act: () => void): Promise<void> {
    if (await this.mayLeave()) act();
  }

  /** A run has moved to another step. */
  moved({ target, detail: step }: CustomEvent<number>, run: Moving): void {
    const { playing } = (target as TimedElement).clock;
    if (!playing && isJump(run.place.step, step)) this.leave();
    run.move({ step });
  }

  /** Whether the scene that the address stores has unsaved changes, made before *Back* or a reload. */
  get isUnsaved(): boolean {
    const kept = history.state as Kept | null;
    return kept !== null && 'isUnsaved' in kept;
  }

  private kept(): Kept | null {
    const { file, place, live } = this.host.session;
    if (file === null) return live.isChanged ? { isUnsaved: true } : null;
    if (!this.files.includes(file)) this.files.push(file);
    return { file: this.files.indexOf(file), step: place.step, pixel: place.pixel };
  }

  /** The file of the current entry of the browser's history; null if it has none, or one from before a reload. */
  private get fileNow(): File | null {
    const kept = history.state as Kept | null;
    return kept !== null && 'file' in kept ? (this.files[kept.file] ?? null) : null;
  }

  /** *Back* or *Forward* to a place in a file. */
  private readonly onPlace = ({ state }: PopStateEvent): void => {
    const { fileNow: file, host } = this;
    if (file === null) return;
    const { step, pixel } = state as PlaceInFile;
    if (file === host.session.file) host.session.move({ step, pixel });
    else void this.visit(() => host.reopen(file, { step, pixel }));
  };

  /** The page is reloaded, closed or left: the browser asks whether to discard the edits. */
  private readonly onUnload = (event: BeforeUnloadEvent): void => {
    if (this.host.session.live.isChanged) event.preventDefault();
  };

  /** The address was changed by a link, by *Back* or by hand. */
  private readonly onAddress = (): void => {
    if (this.fileNow === null) void this.visit(() => this.host.followAddress());
  };

  /** Shows what the address or the browser's history names, unless the reader wants to keep an edited scene. */
  private async visit(show: () => void): Promise<void> {
    const { host, trail } = this;
    const visit = ++this.visits;
    trail.wait();
    const wanted = parseAddress(location.hash).live;
    const now = await host.session.live.carried();
    const isSame = wanted !== null && wanted.scene === now?.scene;
    const isFree = isSame || (await this.mayLeave());
    // The reader went elsewhere while the question was open.
    if (visit !== this.visits) return;
    if (isFree) {
      trail.arrive();
      show();
    } else trail.restore(await addressOf(host));
  }

  private async mayLeave(): Promise<boolean> {
    const { discard, session } = this.host;
    if (!session.live.isChanged) return true;
    const answer = await discard.ask();
    if (answer === 'save') session.live.save();
    return answer !== 'stay';
  }
}
