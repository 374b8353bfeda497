import { formulaOf } from '../run/surface.js';
import type { Formula } from '../run/surface.js';
import type { Header, Scene } from '../trace/header.js';
import type { Trace } from '../replay/trace.js';
import { runnable, usual } from '../run/options.js';
import type { Options } from '../run/options.js';
import { drawPolygon, emptySketch } from '../run/sketch.js';
import type { Sketch, Spot } from '../run/sketch.js';
import { Tracer } from '../run/tracer.js';
import { Undo } from './undo.js';

/** A vertex of a polygon that is being drawn, which has no depth yet. */
export type Corner = readonly [x: number, y: number];

/** The state of the editor; each change makes a new one. */
export interface Editing {
  readonly sketch: Sketch;
  readonly options: Options;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** The vertex that was touched last. */
  readonly chosen: Spot | null;
  /** The corners so far of a polygon that is being drawn. */
  readonly drawn: readonly Corner[] | null;
  /** The messages of the library about the scene: why it was refused, or what it changed. */
  readonly messages: string;
  readonly refused: boolean;
}

/** The requests of the editor's controls. */
export type Act =
  | {
      readonly do: 'edit';
      readonly edit: (sketch: Sketch) => Sketch;
      /** Successive edits with the same name are undone together. */
      readonly name?: string;
    }
  | { readonly do: 'settle' | 'undo' | 'redo' | 'draw' | 'finish' | 'cancel' | 'unpoint' | 'new' }
  | { readonly do: 'point'; readonly at: Corner }
  | { readonly do: 'choose'; readonly spot: Spot | null }
  | { readonly do: 'options'; readonly options: Partial<Options> };

/** The page's reactions to edits. */
export interface Followers {
  changed(editing: Editing): void;
  /** A new change of the scene begins, which will be undone as a whole. */
  began(): void;
  /** There is a trace of the current scene. */
  traced(trace: Trace): void;
  /** A run takes long; later, it is over. */
  slowed(isSlow: boolean): void;
  /** The library refused a scene file. */
  refused(messages: string): void;
  failed(error: unknown): void;
}

/** A scene that is edited and run repeatedly. */
export class Editor {
  private undo = new Undo<Sketch>(emptySketch);
  private options = usual;
  private chosen: Spot | null = null;
  private drawn: readonly Corner[] | null = null;
  private said: Pick<Editing, 'messages' | 'refused'> = { messages: '', refused: false };
  /** A scene file to run with these options. The sketch is to adopt the library's version of it. */
  private adopts: { readonly file: string; readonly options: Options } | null = null;
  private readonly tracer: Tracer;
  /** The frame in which a change is reported at the latest. */
  private frame = 0;

  constructor(
    library: Blob,
    private readonly followers: Followers,
  ) {
    this.tracer = new Tracer(
      library,
      ({ trace, messages }) => this.take(trace, messages),
      (error) => followers.failed(error),
      () => followers.slowed(true),
    );
  }

  /** Continues with the scene of the open trace. */
  open({ scene, method, edition, kernel, detail }: Header): void {
    this.tracer.forget();
    const options = runnable({ method, edition, kernel, detail, check: false });
    this.begin(sketchOf(scene), options);
  }

  /** Runs the text of a scene file unchanged. A refused file changes nothing. */
  load(file: string, options: Options): void {
    this.adopts = { file, options };
    this.tracer.run(file, options);
  }

  /** Cancels the current run. */
  stop(): void {
    this.adopts = null;
    this.tracer.forget();
  }

  get editing(): Editing {
    const { undo, options, chosen, drawn, said } = this;
    const { value, canUndo, canRedo } = undo;
    return { sketch: value, options, canUndo, canRedo, chosen, drawn, ...said };
  }

  act(act: Act): void {
    const { value: before, depth } = this.undo;
    const { options } = this;
    this.perform(act);
    if (this.undo.depth > depth && act.do !== 'redo') this.followers.began();
    if (this.undo.value === before && this.options === options) {
      this.followers.changed(this.editing);
    } else if (!this.run(act.do === 'edit' && act.name !== undefined)) {
      this.tellSoon();
    }
  }

  /**
   * Reports a change together with its run if the run is quick. A page that renders twice for each move cannot follow the
   * pointer.
   */
  private tellSoon(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = requestAnimationFrame(() => this.tell());
    });
  }

  private tell(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.followers.changed(this.editing);
  }

  private begin(sketch: Sketch, options: Options): void {
    this.undo = new Undo(sketch);
    this.options = options;
    this.adopts = null;
    this.chosen = null;
    this.drawn = null;
    this.said = { messages: '', refused: false };
    this.followers.changed(this.editing);
  }

  private perform(act: Act): void {
    const { undo, drawn } = this;
    switch (act.do) {
      case 'edit':
        undo.change(act.edit(undo.value), act.name);
        break;
      case 'settle':
        undo.settle();
        break;
      case 'undo':
        undo.undo();
        break;
      case 'redo':
        undo.redo();
        break;
      case 'new':
        undo.change({ ...emptySketch, area: undo.value.area });
        break;
      case 'draw':
        this.drawn = [];
        break;
      case 'cancel':
        this.drawn = null;
        break;
      case 'unpoint':
        this.drawn = drawn?.slice(0, -1) ?? null;
        break;
      case 'point':
        this.drawn = [...(drawn ?? []), act.at];
        break;
      case 'finish':
        this.finish();
        break;
      case 'choose':
        this.chosen = act.spot;
        break;
      case 'options':
        this.options = runnable({ ...this.options, ...act.options });
    }
  }

  private finish(): void {
    const { drawn, undo } = this;
    if (drawn === null || drawn.length < 3) return;
    undo.change(drawPolygon(undo.value, drawn));
    this.chosen = { polygon: undo.value.polygons.length - 1, vertex: 0 };
    this.drawn = null;
  }

  /**
   * Runs the scene and returns whether the run was reported. A steady change is one of many small ones, such as those of a
   * drag.
   */
  private run(isSteady: boolean): boolean {
    this.adopts = null;
    const { value } = this.undo;
    if (isSteady && this.tracer.runAtOnce(value, this.options)) return true;
    this.tracer.run(value, this.options);
    return false;
  }

  private take(trace: Trace | null, messages: string): void {
    const { adopts, followers } = this;
    this.adopts = null;
    followers.slowed(false);
    if (trace === null && adopts !== null) {
      followers.refused(messages);
      return;
    }
    if (trace !== null && adopts !== null) {
      this.begin(sketchOf(trace.header.scene, formulaOf(adopts.file)), adopts.options);
    }
    this.said = { messages, refused: trace === null };
    if (trace !== null) followers.traced(trace);
    this.tell();
  }
}

function sketchOf({ name, area, background, polygons, curves }: Scene, formula?: Formula): Sketch {
  const sketch = { name, area, background, polygons, curves };
  return formula === undefined ? sketch : { ...sketch, formula };
}
