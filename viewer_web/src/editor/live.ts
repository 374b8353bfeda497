import { download, fileName } from '../base/file.js';
import type { Header } from '../trace/header.js';
import { Editor } from './editor.js';
import type { Act, Editing, Followers } from './editor.js';
import type { Options } from '../run/options.js';
import { packed, wordOf } from '../run/packed.js';
import { sceneFile, sceneText } from '../run/sketch.js';
import type { Sketch } from '../run/sketch.js';

/** A scene as an address stores it, and the settings of its run. */
export interface Carried {
  readonly run: string;
  readonly scene: string;
}

/** The result of a request for a link. */
export type LinkMade = 'copied' | 'saved' | 'tooLong';

const isSame = (one: Editing, other: Editing): boolean =>
  one.sketch === other.sketch && one.options === other.options;

/** The scene that the page edits, if the page has the library to run it. */
export class Live {
  editing: Editing | null = null;
  link: LinkMade | null = null;
  /** Whether a run of this scene is shown, and not an opened trace. */
  isRun = false;
  /** The scene as it was opened. */
  private opened: Sketch | null = null;
  /** The scene as it was last opened or saved; null if it was never saved. */
  private kept: Sketch | null = null;
  /** Whether the scene being opened has unsaved changes from before. */
  private isUnsaved = false;
  /** The scenes saved so far, as texts: the browser's history may still list one as unsaved. */
  private readonly saved = new Set<string>();
  /** The last packed scene, cached because packing takes a while. */
  private last: { readonly editing: Editing; readonly carried: Carried | null } | null = null;
  private readonly editor: Editor | null;

  constructor(
    library: Blob | null,
    private readonly followers: Omit<Followers, 'changed'> & { changed(): void },
  ) {
    const changed = (editing: Editing): void => {
      this.editing = editing;
      const { sketch, canUndo, canRedo } = editing;
      if (!canUndo && !canRedo && sketch !== this.opened) {
        this.opened = sketch;
        this.kept = this.isUnsaved ? null : sketch;
      }
      followers.changed();
    };
    const traced: Followers['traced'] = (trace) => {
      this.isRun = true;
      followers.traced(trace);
    };
    this.editor = library && new Editor(library, { ...followers, changed, traced });
  }

  /** Whether the scene is as it was opened. */
  get isAsOpened(): boolean {
    return this.editing !== null && this.editing.sketch === this.opened;
  }

  /** Whether the scene has unsaved changes. */
  get isChanged(): boolean {
    return this.editing !== null && this.editing.sketch !== this.kept;
  }

  /** Continues with the scene of an opened trace. */
  open(header: Header): void {
    this.isRun = false;
    this.isUnsaved = false;
    this.editor?.open(header);
  }

  /** Runs a scene file, which may have unsaved changes; false if the page was built without the library. */
  load(file: string, options: Options, isUnsaved = false): boolean {
    this.isUnsaved = isUnsaved && !this.saved.has(file);
    this.editor?.load(file, options);
    return this.editor !== null;
  }

  /** Cancels the current run. */
  stop(): void {
    this.editor?.stop();
  }

  act(act: Act): void {
    this.link = null;
    this.editor?.act(act);
  }

  /** Handles undo and redo, unless a field in focus has its own. Returns whether the key was one of these. */
  handleKey(event: KeyboardEvent): boolean {
    const [target] = event.composedPath();
    if (!(event.ctrlKey || event.metaKey) || this.editing === null) return false;
    if (target instanceof HTMLInputElement && target.type !== 'range') return false;
    const isRedo = event.code === 'KeyY' || (event.code === 'KeyZ' && event.shiftKey);
    if (!isRedo && event.code !== 'KeyZ') return false;
    event.preventDefault();
    this.act({ do: isRedo ? 'redo' : 'undo' });
    return true;
  }

  save(): void {
    if (this.editing === null) return;
    const { sketch } = this.editing;
    this.kept = sketch;
    this.saved.add(sceneText(sketch));
    const file = new Blob([sceneFile(sketch)], { type: 'application/json' });
    download(file, `${fileName(sketch.name) || 'scene'}.json`);
    this.followers.changed();
  }

  /** What an address must store to show this run again; null if there is no such run, or it is too long for an address. */
  async carried(): Promise<Carried | null> {
    const { editing } = this;
    if (editing === null || !this.isRun) return null;
    const { last } = this;
    if (last !== null && isSame(last.editing, editing)) return last.carried;
    const scene = await packed(sceneText(editing.sketch));
    const carried = scene === null ? null : { run: wordOf(editing.options), scene };
    this.last = { editing, carried };
    return carried;
  }

  /** What `carried` gives, if it is known at once, or else undefined. */
  get carriedNow(): Carried | null | undefined {
    const { editing, last } = this;
    if (editing === null || !this.isRun) return null;
    return last !== null && isSame(last.editing, editing) ? last.carried : undefined;
  }

  tell(link: LinkMade): void {
    this.link = link;
    this.followers.changed();
  }
}
