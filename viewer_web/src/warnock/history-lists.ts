import type { Apl, Warnock } from '../replay/values.js';
import type { WarnockEvents } from '../trace/events.js';

/** The ids in a list of active polygons. Windows with the same list share the object. */
interface List {
  ids: readonly string[];
}

/** The lists of the windows on the stack and of the current one, without their marks. */
export class Lists {
  private readonly stack: List[] = [];
  private joined: Warnock['joined'] = { surrounding: [], outside: [] };
  private current: List = { ids: [] };
  /** Whether a window on the stack shares the list of the current one, so that changes here affect it. */
  shared = false;

  push({ apl, shared }: WarnockEvents['push']): void {
    const ids = apl?.map(([id]) => id) ?? this.current.ids;
    this.stack.push(shared === true ? this.current : { ids });
  }

  pop(): void {
    this.current = this.stack.pop() ?? { ids: [] };
    this.shared = this.stack.includes(this.current);
  }

  discard(polygon: string): void {
    this.current.ids = this.current.ids.filter((id) => id !== polygon);
  }

  /** The list that all windows share is the third one. */
  join({ polygon, list, level }: WarnockEvents['join']): void {
    this.discard(polygon);
    this.joined = { ...this.joined, [list]: [...this.joined[list], { polygon, level }] };
  }

  rejoin({ polygon, list }: WarnockEvents['rejoin']): void {
    this.current.ids = [...this.current.ids, polygon];
    this.joined = { ...this.joined, [list]: this.joined[list].slice(0, -1) };
  }

  get known(): Pick<Warnock, 'apl' | 'joined'> {
    return { apl: this.apl, joined: this.joined };
  }

  private get apl(): Apl {
    return { entries: this.current.ids.map((id) => [id, false]) };
  }
}
