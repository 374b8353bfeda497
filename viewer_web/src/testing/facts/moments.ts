import type { Edition } from '../../trace/editions.js';
import type { Event, EventName } from '../../trace/events.js';
import type { Moment, ProgramState } from './fact.js';

interface FileHeader {
  readonly detail: string;
  readonly edition: Edition;
  readonly scene: Moment['scene'];
}

type Kept = Pick<Moment, 'level' | 'covered' | 'nearest' | 'counted' | 'height' | 'looked'>;

const begun: Kept = {
  level: 0,
  covered: [null, null],
  nearest: null,
  counted: 0,
  height: null,
  looked: 0,
};

type Change<K extends EventName> = (
  event: Event<K>,
  kept: Kept,
  levels: number[],
) => Partial<Kept> | undefined;

const changes: { readonly [K in EventName]?: Change<K> } = {
  push: ({ at }, { level }, levels) => {
    levels.push(['W3', 'WS1', 'WF1'].includes(at) ? 0 : level + 1);
    return undefined;
  },
  pop: (_event, _kept, levels) => ({
    level: levels.pop() ?? NaN,
    covered: [null, null],
    nearest: null,
  }),
  corners: () => ({ covered: [null, null] }),
  cover: ({ polygon }, { covered }) => ({ covered: [covered[1], polygon] }),
  uncover: (_event, { covered }) => ({ covered: [covered[1], null] }),
  hiding: ({ polygon = null }, { covered }) => ({ covered: [covered[1], polygon] }),
  nearest: ({ polygon }) => ({ nearest: polygon }),
  call: () => ({ counted: 0 }),
  ray: ({ counts }, { counted }) => ({ counted: counted + counts }),
  octants: ({ difference }, { counted }) => ({ counted: counted + difference }),
  curve: () => ({ height: null }),
  height: (event) => ({ height: event }),
  pop_list: () => ({ looked: 0 }),
  beside: (_event, { looked }) => ({ looked: looked + 1 }),
  clipped: ({ at }, { looked }) => (at === 'WA5' ? { looked: looked + 1 } : undefined),
};

/** The data around each event of a run, from the events as written, independent of the page's own state. */
export class Moments {
  private kept = begun;
  /** The levels of the windows on the stack. */
  private readonly levels: number[] = [];

  constructor(private readonly header: FileHeader) {}

  take(event: Event, after: ProgramState): Moment {
    const [, covering] = this.kept.covered;
    this.kept = { ...this.kept, covered: [covering, covering], ...this.change(event) };
    const { detail, edition, scene } = this.header;
    return { ...this.kept, after, detail, edition, scene };
  }

  private change(event: Event): Partial<Kept> {
    const change = changes[event.e] as Change<EventName> | undefined;
    return change?.(event, this.kept, this.levels) ?? {};
  }
}
