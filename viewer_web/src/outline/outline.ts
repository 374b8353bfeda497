import { algorithmOf } from '../algorithm/algorithm.js';
import type { Language } from '../language/language.js';
import type { Trace } from '../replay/trace.js';
import type { Book } from '../time/course.js';
import { callsFrom, depthChanges, eventNames, kinds, numberOf } from '../trace/events.js';
import type { EventName, Procedure } from '../trace/events.js';
import type { Kind, NodeData } from './outlined.js';
import { NodeTable, none } from './table.js';

const atOnce = 8192;

/** The kinds of nodes by their numbers in the table. */
const kindsByNumber: readonly Kind[] = [
  'item',
  'part',
  ...(Object.keys(callsFrom) as readonly Procedure[]),
];
const [item, part] = [0, 1];
/** The kind of a call that has no result yet. */
const pending = 255;

const call = numberOf.get('call') ?? -1;

/** For each event name, the kind of the procedure that it is a result of; 0 if there is none. */
const resultOf = eventNames.map((name) => {
  const { resultOf: procedure } = kinds[name];
  return procedure === undefined ? 0 : kindsByNumber.indexOf(procedure);
});

/**
 * The outline of a run: a tree of its items, such as nested windows, with their parts and the procedure calls. It is built
 * in one pass over the event names, which a page may spread over frames and which continues as the trace grows. The texts
 * of nodes are made when they are shown.
 */
export class Outline {
  readonly nodes = new NodeTable();
  private seen = 0;
  private atTop = 0;
  /** The open nodes: first the current items, each nested in the one before it, then possibly a part, then calls. */
  private open: number[] = [];
  /** The number of open nodes that are current items. */
  private currentItem = 0;
  private readonly closesCall: readonly boolean[];
  private readonly watch: readonly (((step: number) => void) | undefined)[];

  constructor(readonly trace: Trace) {
    const { header } = trace;
    const { course, outline } = algorithmOf(header);
    this.closesCall = depthChanges(header.detail).map((change) => change === -1);
    const watched = course(this.book());
    const parts = new Set(outline.parts);
    this.watch = eventNames.map((name) =>
      parts.has(name) ? (step) => this.beginPart(step) : watched[name],
    );
  }

  get size(): number {
    return this.nodes.size;
  }

  /** The number of nodes at the top level. */
  get topSize(): number {
    return this.atTop;
  }

  /** Whether all steps read so far were processed. */
  get isUpToDate(): boolean {
    return this.seen >= this.trace.timeline.length;
  }

  get complete(): boolean {
    return this.trace.complete && this.isUpToDate;
  }

  /** Continues for about this time. Returns whether all steps read so far were processed. */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    do this.readSome();
    while (!this.isUpToDate && performance.now() < end);
    return this.isUpToDate;
  }

  kindOf(node: number): Kind {
    const { kind, first } = this.nodes;
    const known = kindsByNumber[kind[node] ?? item];
    if (known !== undefined) return known;
    const event = this.trace.timeline.event(first[node] ?? 0);
    return event?.e === 'call' ? event.of : 'item';
  }

  /** The row after a node and its descendants. */
  endOf(node: number): number {
    const end = this.nodes.end[node] ?? 0;
    return end === 0 ? this.size : end;
  }

  lastOf(node: number): number {
    const { end, last } = this.nodes;
    return end[node] === 0 ? this.seen : (last[node] ?? 0);
  }

  /** The last node that begins at or before a step; `none` before the first. */
  before(step: number): number {
    const { first, size } = this.nodes;
    let from = 0;
    let end = size;
    while (from < end) {
      const middle = (from + end) >> 1;
      if ((first[middle] ?? Infinity) <= step) from = middle + 1;
      else end = middle;
    }
    return from === 0 ? none : from - 1;
  }

  /** The innermost node that contains a step; `none` if there is none. */
  at(step: number): number {
    let node = this.before(step);
    while (node !== none && this.lastOf(node) < step) node = this.nodes.parent[node] ?? none;
    return node;
  }

  /** A node and its ancestors, from the inside out. */
  *wayUp(node: number): Generator<number> {
    for (let at = node; at !== none; at = this.nodes.parent[at] ?? none) yield at;
  }

  /** The innermost item at or above a node; `none` if there is none. */
  itemOf(node: number): number {
    for (const at of this.wayUp(node)) if (this.nodes.kind[at] === item) return at;
    return none;
  }

  isItem(node: number): boolean {
    return this.nodes.kind[node] === item;
  }

  isPart(node: number): boolean {
    return this.nodes.kind[node] === part;
  }

  dataOf(node: number): NodeData {
    const { header, timeline } = this.trace;
    const { first: firsts, part: parts } = this.nodes;
    const [first, last] = [firsts[node] ?? 0, this.ownLast(node)];
    return {
      header,
      kind: this.kindOf(node),
      first,
      last,
      itemFrom: firsts[this.itemOf(node)] ?? first,
      part: parts[node] ?? -1,
      event: (step) => timeline.event(step),
      note: (step, language) => timeline.note(step, language),
      stepsOf: (name, from = first) => stepsOf(timeline.names, name, from, last),
    };
  }

  /** The last step of a node before another item becomes current. */
  private ownLast(node: number): number {
    const { first, kind } = this.nodes;
    const end = this.endOf(node);
    for (let row = node + 1; row < end; row++) {
      if (kind[row] === item) return (first[row] ?? 0) - 1;
    }
    return this.lastOf(node);
  }

  private readSome(): void {
    const { names } = this.trace.timeline;
    const end = Math.min(this.seen + atOnce, names.length);
    while (this.seen < end) {
      const name = names[this.seen] ?? 0;
      this.seen++;
      this.watch[name]?.(this.seen);
      if (name === call) this.begin(this.seen, pending, -1);
      else if (resultOf[name] !== 0) this.finish(this.seen, name);
    }
  }

  /** Begins a node in the innermost open one. */
  private begin(step: number, kind: number, value: number): number {
    const { nodes, open } = this;
    const parent = open.at(-1) ?? none;
    const node = nodes.add();
    nodes.first[node] = step;
    nodes.parent[node] = parent;
    const place = parent === none ? ++this.atTop : (nodes.children[parent] ?? 0) + 1;
    if (parent !== none) nodes.children[parent] = place;
    nodes.place[node] = place;
    nodes.depth[node] = open.length + 1;
    nodes.kind[node] = kind;
    nodes.part[node] = value;
    open.push(node);
    return node;
  }

  /** Closes all open nodes except the given number. */
  private close(left: number, last: number): void {
    const { nodes, open } = this;
    for (const node of open.splice(left)) {
      nodes.last[node] = last;
      nodes.end[node] = nodes.size;
    }
  }

  private beginPart(step: number): void {
    this.close(this.currentItem, step - 1);
    this.begin(step, part, -1);
  }

  /** The result of a procedure ends its call. In a trace without calls the result is a node of its own. */
  private finish(step: number, name: number): void {
    const top = this.open.at(-1) ?? none;
    const isCalled = this.closesCall[name] === true && this.nodes.kind[top] === pending;
    const node = isCalled ? top : this.begin(step, pending, -1);
    this.nodes.kind[node] = resultOf[name] ?? pending;
    this.close(this.open.length - 1, step);
  }

  /** Turns the records of the run's course into nodes. */
  private book(): Book {
    const { trace } = this;
    const indices = new Map(trace.header.scene.polygons.map(({ id }, i) => [id, i]));
    return {
      header: trace.header,
      eventAt: (step) => trace.timeline.event(step),
      indexOf: (polygon) => indices.get(polygon) ?? -1,
      begin: (step, value, level = 1) => {
        const left = Math.min(level - 1, this.currentItem);
        this.close(left, step - 1);
        this.begin(step, item, value);
        this.currentItem = left + 1;
      },
      end: (step) => {
        this.close(0, step - 1);
        this.currentItem = 0;
      },
      decide: (value) => {
        const node = this.open[this.currentItem - 1];
        if (node !== undefined) this.nodes.part[node] = value;
      },
      changeAel: () => undefined,
    };
  }
}

function stepsOf(
  names: Uint8Array,
  name: EventName,
  from: number,
  last: number,
): readonly number[] {
  const wanted = numberOf.get(name);
  const found: number[] = [];
  for (let step = from; step <= last; step++) if (names[step - 1] === wanted) found.push(step);
  return found;
}

const outlines = new WeakMap<Trace, Outline>();

/** The outline of a run, as far as it has been built. */
export function outlineOf(trace: Trace): Outline {
  const known = outlines.get(trace) ?? new Outline(trace);
  outlines.set(trace, known);
  return known;
}

/** The maximum length of a note: a list in it may be far longer than a row. */
const longest = 60;

/** A procedure with its result, as in the listing's notes: "SurroundTest A: true". */
function sayCall({ kind, last, event, note: noteOf }: NodeData, language: Language): string {
  const result = event(last);
  if (result === null || kinds[result.e].resultOf !== kind) return kind;
  const polygon = 'polygon' in result ? (result.polygon ?? '') : '';
  const note = noteOf(last, language).slice(0, longest);
  if (note === '' || note === polygon || note.startsWith(`${polygon}:`)) {
    return `${kind} ${note || polygon}`.trim();
  }
  return `${polygon === '' ? kind : `${kind} ${polygon}`}: ${note}`;
}

/** The text of a node. */
export function sayNode(outline: Outline, node: number, language: Language): string {
  const data = outline.dataOf(node);
  return algorithmOf(data.header).outline.say(data, language) ?? sayCall(data, language);
}
