import { eventNames } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import { Refusal } from '../trace/refusal.js';
import { changeApl, currentApl } from './lists.js';
import { effects } from './state.js';
import type { Warnock } from './state.js';

type Change = Event<'discard' | 'mark'>;

const isChange = (event: Event): event is Change => event.e === 'discard' || event.e === 'mark';

/** The events that need the list to be up to date. */
const lookers: ReadonlySet<EventName> = new Set(
  eventNames.filter((name) =>
    effects.uses.fieldsOf(name).some((it) => it === 'apl' || it === 'stack'),
  ),
);

/**
 * The list of active polygons while polygons are removed or marked. The list itself is rebuilt only when an event needs it:
 * a copy for each of thousands of polygons would take seconds.
 */
export class ListInHand {
  private entries: Map<string, boolean> | null = null;

  /** Records a change of the list, which is not in the state yet; ignores any other event. */
  take(event: Event, now: Warnock): boolean {
    if (!isChange(event)) return false;
    const { polygon } = event;
    this.entries ??= new Map(currentApl(now).entries);
    if (!this.entries.has(polygon)) throw new Refusal('polygon', 'notInList', polygon);
    if (event.e === 'mark') this.entries.set(polygon, true);
    else this.entries.delete(polygon);
    return true;
  }

  /** The state that an event needs. */
  before({ e }: Event, now: Warnock): Warnock {
    return lookers.has(e) ? this.settled(now) : now;
  }

  /** The state with the updated list. */
  settled(now: Warnock): Warnock {
    if (this.entries === null) return now;
    const entries = [...this.entries];
    this.entries = null;
    return { ...now, ...changeApl(now, entries) };
  }

  /** Discards the changes, because another state replaces this one. */
  forget(): void {
    this.entries = null;
  }
}
