import { details, eventNames } from '../trace/events.js';
import type { Event } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { kindsOf } from '../trace/kinds.js';
import type { LineKind } from '../trace/kinds.js';
import { parseLine } from '../trace/parse.js';
import type { End } from '../trace/parse.js';
import type { BlockText } from '../trace/store.js';
import { modelOf } from './model.js';
import { Bounds } from './screen.js';
import { State } from './state.js';

/** On a longer text a regular expression may run out of space. */
const longestPlain = 2 ** 13;
const opening = '{"e":"';

/**
 * A run while it is read. Checks each line, and that its event can happen at its place. Lines in the form of a run are
 * recognized by a regular expression. Such a line is not parsed if its event can neither be refused nor affect a later
 * refusal.
 */
export class Run {
  length = 0;
  private readonly state: State;
  private readonly kinds: ReadonlyMap<string, LineKind>;
  private readonly ids: ReadonlySet<string>;
  private readonly decisive: readonly boolean[];

  constructor(private readonly header: Header) {
    const { method, detail, scene } = header;
    const level = details.indexOf(detail);
    const kinds = [...kindsOf[method]].filter(([, { from }]) => details.indexOf(from) <= level);
    this.state = new State(header, new Bounds(header));
    this.kinds = new Map(kinds);
    this.ids = new Set(scene.polygons.map(({ id }) => JSON.stringify(id)));
    const { decisive } = modelOf(header).uses;
    this.decisive = eventNames.map((name, i) => decisive[i] === true || name === 'call');
  }

  /** The number of the event's name on a line of the block, or the last line. */
  take(block: BlockText, line: number): number | End {
    const kind = this.plainKind(block, line);
    if (kind === null) return this.takeParsed(block.line(line));
    this.length++;
    if (this.decisive[kind.number] === true) {
      this.state.check(JSON.parse(block.line(line)) as Event);
    } else this.state.pass(kind.name);
    return kind.number;
  }

  /** The kind of a line that certainly belongs to it, and names a polygon of the scene if it names any. */
  private plainKind(block: BlockText, line: number): LineKind | null {
    const [text, start, end] = block.at(line);
    if (end - start > longestPlain || !text.startsWith(opening, start)) return null;
    const from = start + opening.length;
    const kind = this.kinds.get(text.slice(from, text.indexOf('"', from)));
    if (kind === undefined) return null;
    kind.plain.lastIndex = start;
    const match = kind.plain.exec(text);
    if (match === null) return null;
    return match[1] === undefined || this.ids.has(match[1]) ? kind : null;
  }

  private takeParsed(text: string): number | End {
    const found = parseLine(text, this.header);
    if ('end' in found) return found.end;
    this.length++;
    this.state.check(found.event);
    return this.kinds.get(found.event.e)?.number ?? 0;
  }
}
