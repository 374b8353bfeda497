import type { CommonEvents, Event, EventName } from '../trace/events.js';
import { Uses } from './uses.js';
import type { Use } from './uses.js';

/** What an event does to the values of a run and to the paper, and which of their fields it uses. */
interface Effect<K extends EventName, Now, Paper> extends Use<Field<Now>> {
  /** Gives the new values, if any. Throws if the event cannot happen here. Without it all values stay. */
  readonly does?: (event: Event<K>, now: Now, paper: Paper) => Partial<Now> | undefined;
}

/** A field of the values, or a part of the paper. */
type Field<Now> =
  (keyof Now & string) | 'picture' | 'division' | 'z' | 'horizons' | 'flags' | 'before';

type EffectsOf<K extends EventName, Now, Paper> = { readonly [N in K]: Effect<N, Now, Paper> };

export const nothing = {};

/** Events that all algorithms have usually change nothing. */
export const noneOfCommon: Readonly<Record<keyof CommonEvents, typeof nothing>> = {
  plane: nothing,
  call: nothing,
  depth: nothing,
  fault: nothing,
  disagree: nothing,
};

/** The effects of all events of an algorithm. */
export class Effects<K extends EventName, Now, Paper> {
  readonly uses: Uses;
  private readonly effects: Readonly<Partial<Record<EventName, Effect<EventName, Now, Paper>>>>;

  constructor(effects: EffectsOf<K | keyof CommonEvents, Now, Paper>) {
    this.uses = new Uses(effects);
    this.effects = effects as unknown as typeof this.effects;
  }

  /** The values after an event of the algorithm. */
  after(event: Event, now: Now, paper: Paper): Now {
    const news = this.effects[event.e]?.does?.(event, now, paper);
    return news === undefined ? now : { ...now, ...news };
  }
}
