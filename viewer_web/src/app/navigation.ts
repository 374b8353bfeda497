import type { ReactiveController, ReactiveControllerHost } from 'lit';
import { parseAddress } from '../reader/address.js';
import type { DiscardElement } from '../editor/discard.js';
import type { TimedElement } from '../player/timed.js';
import { addressNow, addressOf } from './sharing.js';
import type { Shared } from './sharing.js';
import { Trail, isJump } from './trail.js';

/** What is gone about in. */
export interface Travelled extends Shared, ReactiveControllerHost {
  readonly discard: DiscardElement;
  followAddress(): void;
}

/** The ways from what is shown to something else: each can be undone, and none takes away what was edited unasked. */
export class Navigation implements ReactiveController {
  private readonly trail = new Trail(() => addressOf(this.host));

  constructor(private readonly host: Travelled) {
    host.addController(this);
  }

  hostConnected(): void {
    window.addEventListener('hashchange', this.onAddress);
  }

  hostDisconnected(): void {
    window.removeEventListener('hashchange', this.onAddress);
  }

  /** What is shown has changed. */
  write(): void {
    this.trail.write();
  }

  /** Something else is about to be shown; *Back* shall lead here again. */
  leave(): void {
    // In a frame the steps back are those of the page around it.
    if (!this.host.setup.setting.embed) this.trail.leave(addressNow(this.host));
  }

  /** Does what takes the place of the scene; if that was changed, only when the reader agrees. */
  async replace(act: () => void): Promise<void> {
    if (await this.mayLeave()) act();
  }

  /** The run has come to another step. */
  moved({ target, detail: step }: CustomEvent<number>): void {
    const { session } = this.host;
    const { playing } = (target as TimedElement).clock;
    if (!playing && isJump(session.place.step, step)) this.leave();
    session.move({ step });
  }

  /** Another address was asked for: by a link, by *Back*, by hand. */
  private readonly onAddress = (): void => void this.visit();

  private async visit(): Promise<void> {
    const { host } = this;
    const wanted = parseAddress(location.hash).live;
    const now = await host.session.live.carried();
    const isSame = wanted !== null && wanted.scene === now?.scene;
    if (isSame || (await this.mayLeave())) host.followAddress();
    else this.trail.restore(await addressOf(host));
  }

  private async mayLeave(): Promise<boolean> {
    const { discard, session } = this.host;
    if (!session.live.isChanged) return true;
    const answer = await discard.ask();
    if (answer === 'save') session.live.save();
    return answer !== 'stay';
  }
}
