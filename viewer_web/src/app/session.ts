import type { ReactiveController, ReactiveControllerHost } from 'lit';
import { rest } from '../elements/read-on.js';
import { textOf } from '../base/file.js';
import { embeddedAtlas } from '../atlas/entries.js';
import type { Entry } from '../atlas/entries.js';
import { Rival } from '../compare/rival.js';
import type { With } from '../compare/rival.js';
import { Witness } from '../compare/witness.js';
import { Live } from '../editor/live.js';
import type { Carried } from '../editor/live.js';
import { embeddedFile, idOf } from '../lessons/lessons.js';
import type { LessonTrace } from '../lessons/lessons.js';
import type { Address } from '../reader/address.js';
import { openTrace } from '../replay/open.js';
import type { Readers } from '../replay/open.js';
import type { Trace } from '../replay/trace.js';
import type { Margin } from '../exactness/margin.js';
import { Checks } from '../run/checks.js';
import { Margins } from '../run/margins.js';
import { emptySketch, sceneText } from '../run/sketch.js';
import type { Spot } from '../run/sketch.js';
import { ExactPicture } from '../run/exact.js';
import { Promised, embeddedLibrary, moduleOf } from '../run/maker.js';
import { meshRequest } from '../run/mesh.js';
import { noticeOf, noticeOfRun } from '../run/notice.js';
import type { Lacks, Notice } from '../run/notice.js';
import { brief } from '../run/options.js';
import type { Options } from '../run/options.js';
import { optionsOf, unpacked, wordOf } from '../run/packed.js';
import { failureIn } from '../run/failures.js';
import type { Failure } from '../run/failures.js';
import { isMesh, kindOf, kindOfFile } from '../run/file-kind.js';
import { SignMaps } from '../run/sign-maps.js';
import { firstSurface, isSurface, surfaceText } from '../run/surface.js';
import { ownStep } from '../time/place.js';
import { details } from '../trace/events.js';

/** A place in a trace: the step, and what is marked. */
export type Place = Pick<Address, 'pixel' | 'bookmarks'> & { readonly step: number };
const beginning: Place = { step: 0, pixel: null, bookmarks: [] };

/** The place in the run of a failure that an address names; without a step of its own, the step where the failure shows. */
type Wanted = Pick<Address, 'step' | 'pixel' | 'bookmarks' | 'rival'>;
const whereSeen: Wanted = { step: null, pixel: null, bookmarks: [], rival: null };
const nothing = (): void => undefined;

/** What the atlas of the page knows of an open failure: the name of its entry, and why its picture has no proof. */
interface Known {
  readonly entry: string | null;
  readonly unproved: Entry['unproved'];
}

/** How a failure is opened: as an entry of the atlas or not, and at which place. */
interface Named extends Known {
  readonly wanted: Wanted;
  readonly arrive: () => void;
}
const unnamed: Named = { entry: null, unproved: null, wanted: whereSeen, arrive: nothing };

function placeIn({ step: seenAt, pixel: seen }: Failure, wanted: Wanted): Place {
  const { step, pixel, bookmarks } = wanted;
  return { step: step ?? seenAt ?? Infinity, pixel: step === null ? seen : pixel, bookmarks };
}

type OpenFailure = Failure & Known;

/** Where a scene comes from: a failure that it shows, a mesh that it lacks parts of, or earlier edits that were not saved. */
interface Origin {
  readonly failure?: OpenFailure | null;
  readonly lacks?: Lacks | null;
  readonly isUnsaved?: boolean;
  readonly arrive?: () => void;
}

/** The word in an address for the run that is correct, if it has a scene of its own. */
const remedy = 'remedy';

const remedyOf = ({ holds: options, holdsScene: scene }: Failure): With =>
  scene === null ? { kind: 'run', options } : { kind: 'other', options, scene, word: remedy };

/** The open lesson, file or edited scene, and the place in it. Reports each change. */
export class Session implements ReactiveController {
  trace: Trace | null = null;
  /** The number of its steps read so far. */
  steps = 0;
  lesson: string | null = null;
  place = beginning;
  /** The reader's own file, if one is open. */
  file: File | null = null;
  notice: Notice | null = null;
  /** The failure whose scene is open. */
  failure: OpenFailure | null = null;
  /** What the open scene lacks of the mesh that it was made of. */
  lacks: Lacks | null = null;
  /** Whether the scene is at rest. During a drag, the page computes only what a frame shows. */
  isResting = true;
  private timer = 0;
  /** The trace that was shown before the last change of the scene. */
  earlier: Trace | null = null;
  readonly live: Live;
  readonly exact: ExactPicture;
  readonly maps: SignMaps | null;
  readonly checks: Checks | null;
  readonly margins: Margins | null;
  readonly rival: Rival;
  readonly witness: Witness;
  private readonly failures: Promised<'failure'> | null;
  private readonly meshes: Promised<'scene'> | null;

  /** The place to show in the next run of a scene: the current one, unless a link says otherwise. */
  private goal: Place | null = null;
  /** What will belong to the scene that runs next. */
  private next: Pick<Session, 'failure' | 'lacks'> = { failure: null, lacks: null };
  /** The name of the last request, which may be refused. */
  private asked = '';
  private stopReading = (): void => undefined;
  /** Called before the next run of a scene takes the place of what is open. */
  private arrive = nothing;

  constructor(
    host: ReactiveControllerHost,
    private readonly changed: () => void,
    readonly library = embeddedLibrary(document),
  ) {
    host.addController(this);
    // Loads the library early, so that the first run of a scene does not wait for it.
    if (library !== null) requestIdleCallback(() => void moduleOf(library).catch(() => undefined));
    this.maps = library && new SignMaps(library);
    this.checks = library && new Checks(library, changed);
    this.margins = library && new Margins(library, changed);
    this.failures = library && new Promised(library, 'failure');
    this.meshes = library && new Promised(library, 'scene');
    this.exact = new ExactPicture(library, changed);
    this.rival = new Rival(library, changed);
    this.witness = new Witness(library, changed);
    this.live = new Live(library, {
      changed,
      began: () => (this.earlier = this.trace),
      traced: (trace) => this.showRun(trace),
      slowed: (isSlow) => {
        if (isSlow) this.say({ kind: 'running' });
        else if (this.notice?.kind === 'running') this.say(null);
      },
      refused: (messages) => {
        this.goal = null;
        this.say({ kind: 'refused', name: this.asked, messages });
      },
      failed: (error) => this.fail(this.asked, error),
    });
  }

  /** The region to which a vertex may be moved; null while it is not known. */
  marginAt(trace: Trace, spot: Spot): Margin | null {
    if (!this.isResting) return null;
    return this.margins?.of(trace, this.place.step, spot) ?? null;
  }

  /** Whether the failing run is shown and nothing about it was changed. */
  get isFailing(): boolean {
    const { failure, live } = this;
    const options = live.editing?.options;
    return (
      failure !== null &&
      options !== undefined &&
      live.isAsOpened &&
      wordOf(options) === wordOf(failure.fails)
    );
  }

  /** The entry of the atlas that is shown. */
  get entry(): string | null {
    return this.isFailing ? (this.failure?.entry ?? null) : null;
  }

  /** Whether an address can reopen what is shown. */
  get isLinked(): boolean {
    return this.lesson !== null || this.live.isRun;
  }

  /** Whether the page can run scenes. */
  get canRun(): boolean {
    return this.maps !== null;
  }

  /** Whether the run is shown beside another one. */
  get isCompared(): boolean {
    return this.trace !== null && this.rival.trace !== null;
  }

  /** Whether a run, or the reason why there is none, will soon be shown. */
  get isOpening(): boolean {
    const { notice, live } = this;
    return notice === null ? live.editing !== null : /^(?:reading|running)$/u.test(notice.kind);
  }

  hostDisconnected(): void {
    this.stopReading();
    clearTimeout(this.timer);
  }

  async openLesson(chosen: LessonTrace, place = beginning): Promise<void> {
    const { file: name, ...run } = chosen;
    const file = embeddedFile(document, name);
    if (file === null) return;
    if (!name.endsWith('.json')) {
      this.open(file, name, idOf(chosen), place);
      return;
    }
    const text = await textOf(file);
    if (kindOf(text) === 'failure') await this.openFailure(text, name);
    else this.openScene(text, name, { check: false, ...run }, place);
  }

  /**
   * Opens a file, with others that it names if it is a mesh. A trace opens at the place. A refused file leaves everything as it
   * is; `arrive` is called before another one is shown.
   */
  async openFiles(files: readonly File[], arrive: () => void, place = beginning): Promise<void> {
    const file = files.find((each) => isMesh(each.name)) ?? files[0];
    if (file === undefined) return;
    const { name } = file;
    const kind = isMesh(name) ? 'mesh' : await kindOfFile(file);
    if (kind === 'chart') {
      this.say({ kind, name });
      return;
    }
    if (kind === 'mesh') {
      await this.openMesh([file, ...files.filter((each) => each !== file)], name, arrive);
      return;
    }
    if (kind === 'trace') {
      this.open(file, name, null, place, arrive);
      return;
    }
    try {
      const text = await textOf(file);
      if (kind === 'failure') await this.openFailure(text, name, { ...unnamed, arrive });
      else this.openOwn(text, name, arrive);
    } catch (error) {
      this.fail(name, error);
    }
  }

  private async openMesh(files: readonly File[], name: string, arrive: () => void): Promise<void> {
    this.stopReading();
    this.say({ kind: 'reading', name });
    const request = await meshRequest(files).catch(() => null);
    if (this.meshes === null || request === null) {
      this.fail(name, null);
      return;
    }
    const { made, messages } = await this.meshes.ask(request);
    if (made === null) {
      if (messages === '') this.fail(name, null);
      else this.say({ kind: 'unread', name, why: messages });
      return;
    }
    const losses = messages.split('\n').filter((loss) => loss !== '');
    const lacks = losses.length === 0 ? null : ({ kind: 'lacks', name, losses } as const);
    this.openScene(made, name, brief, beginning, { arrive, lacks });
  }

  /** Opens an entry of the page's atlas by its name in the address. */
  async openEntry(name: string, wanted: Wanted = whereSeen, arrive = nothing): Promise<void> {
    const { failure } = this;
    if (failure !== null && this.entry === name) {
      this.move(placeIn(failure, wanted));
      this.besideRemedy(failure, wanted);
      return;
    }
    this.stopReading();
    this.say({ kind: 'reading', name });
    const entries = await embeddedAtlas(document);
    const entry = entries.find((each) => each.name === name && each.scene !== undefined);
    if (entry === undefined) {
      this.miss(name);
      return;
    }
    const { text, unproved } = entry;
    await this.openFailure(text, name, { entry: name, unproved, wanted, arrive });
  }

  /**
   * Runs the scene of a failure with its failing settings, and goes to the wanted step or to the one where the failure
   * shows.
   */
  async openFailure(
    text: string,
    name: string,
    { entry, unproved, wanted, arrive }: Named = unnamed,
  ): Promise<void> {
    this.stopReading();
    this.say({ kind: 'reading', name });
    if (this.failures === null) {
      this.fail(name, null);
      return;
    }
    const found = await failureIn(text, this.failures);
    if ('messages' in found) {
      this.say({ kind: 'refused', name, messages: found.messages });
      return;
    }
    const failure = { ...found.failure, entry, unproved };
    const { scene, fails } = failure;
    this.openScene(scene, name, fails, placeIn(failure, wanted), { failure, arrive });
    this.besideRemedy(failure, wanted);
  }

  /** Closes the failure, but keeps its scene open like any other. */
  forgetFailure(): void {
    this.failure = null;
    this.changed();
  }

  /** Shows the failing run beside the correct one, or alone again. */
  compareWithRemedy(): void {
    const { failure, rival } = this;
    if (failure === null) return;
    rival.choose(rival.chosen === null ? remedyOf(failure) : null);
  }

  private besideRemedy(failure: Failure, wanted: Wanted): void {
    const { rival } = this;
    if (wanted.rival === remedy && rival.word !== remedy) rival.choose(remedyOf(failure));
  }

  /** Opens a scene without polygons, and begins to draw one. */
  openEmpty(arrive: () => void): void {
    this.openOwn(sceneText(emptySketch), '', () => {
      arrive();
      queueMicrotask(() => this.live.act({ do: 'draw' }));
    });
  }

  /** Opens a surface, chosen by the page, that is given by a function. */
  openSurface(name: string, arrive: () => void): void {
    this.openOwn(surfaceText(firstSurface(name)), name, arrive);
  }

  private openOwn(text: string, name: string, arrive: () => void): void {
    const options: Options = isSurface(text) ? { ...brief, method: 'floating-horizon' } : brief;
    this.openScene(text, name, options, beginning, { arrive });
  }

  /** Opens a scene that an address stores. It may have unsaved changes from before. */
  async openCarried({ run, scene }: Carried, place: Place, isUnsaved: boolean): Promise<void> {
    const now = await this.live.carried();
    if (now?.run === run && now.scene === scene) {
      this.move(place);
      return;
    }
    try {
      this.openScene(await unpacked(scene), '', optionsOf(run), place, { isUnsaved });
    } catch (error) {
      this.fail('', error);
    }
  }

  /** Reports that an address names a run that is not here. */
  miss(name: string): void {
    this.say({ kind: 'unknown', name });
  }

  /** The name of the open scene. */
  get name(): string {
    return this.trace?.header.scene.name ?? '';
  }

  /** Stops reading the file and keeps the steps read so far, or cancels a run. */
  stop(): void {
    this.stopReading();
    if (this.notice?.kind === 'running') {
      this.live.stop();
      this.goal = null;
    }
    const { trace, notice } = this;
    if (trace === null || notice?.kind !== 'growing') {
      this.say(null);
      return;
    }
    this.cut(trace);
    this.say(noticeOf(trace));
  }

  private cut(trace: Trace): void {
    trace.end('stopped');
    this.steps = trace.timeline.length;
  }

  move(change: Partial<Place>): void {
    this.place = { ...this.place, ...change };
    this.changed();
  }

  private openScene(
    text: string,
    name: string,
    options: Options,
    place: Place,
    { failure = null, lacks = null, isUnsaved = false, arrive = nothing }: Origin = {},
  ): void {
    this.stopReading();
    this.arrive = arrive;
    this.asked = name;
    this.goal = place;
    this.next = { failure, lacks };
    if (this.live.load(text, options, isUnsaved)) this.say(null);
    else this.fail(name, null);
  }

  /** Shows a run of the current scene, at the same step as before or at its end. */
  private showRun(trace: Trace): void {
    const { length } = trace.timeline;
    const atEnd = this.steps > 0 && this.place.step === this.steps;
    const old = this.trace?.timeline ?? trace.timeline;
    const step = atEnd ? length : ownStep(old, this.place.step, trace.timeline);
    const { goal } = this;
    this.wait(goal === null);
    if (goal !== null) {
      this.arrive();
      this.earlier = null;
      Object.assign(this, this.next);
    }
    this.file = null;
    const place = goal === null ? { step } : { ...goal, step: Math.min(goal.step, length) };
    this.show(trace, null, { ...this.place, ...place });
    this.goal = null;
    this.say(noticeOfRun(trace));
  }

  /** Runs the current scene again with as few steps as possible. */
  coarsen(): void {
    this.live.act({ do: 'options', options: { detail: details[0] } });
  }

  /** Waits until the scene has not changed for a while. */
  private wait(isChanging: boolean): void {
    clearTimeout(this.timer);
    this.isResting = !isChanging;
    if (!isChanging) return;
    this.timer = window.setTimeout(() => {
      this.isResting = true;
      this.changed();
    }, rest);
  }

  private open(
    file: Blob,
    name: string,
    lesson: string | null,
    place: Place,
    arrive = nothing,
  ): void {
    this.stopReading();
    this.goal = null;
    this.earlier = null;
    this.say({ kind: 'reading', name });
    const readers: Readers = {
      grown: (trace) => {
        const { length } = trace.timeline;
        if (this.trace === trace) this.steps = length;
        else if (trace.complete || length >= place.step) {
          arrive();
          this.file = lesson === null && file instanceof File ? file : null;
          this.failure = null;
          this.lacks = null;
          if (lesson === null) this.checks?.doubt(trace);
          this.show(trace, lesson, place);
          this.live.open(trace.header);
        }
        if (this.trace === trace) this.say(noticeOf(trace));
      },
      failed: (error) => {
        // The trace before may have been half read; it is shown as far as that.
        if (this.trace?.complete === false) this.cut(this.trace);
        this.fail(name, error);
      },
    };
    this.stopReading = openTrace(file, readers);
  }

  private show(trace: Trace, lesson: string | null, place: Place): void {
    if (this.trace !== null) this.witness.close();
    this.trace = trace;
    this.steps = trace.timeline.length;
    this.asked = this.name;
    this.lesson = lesson;
    this.place = { ...place, step: Math.min(place.step, this.steps) };
    this.rival.follow(trace.header.scene);
    this.changed();
  }

  private fail(name: string, error: unknown): void {
    this.say({ kind: 'failed', name, error });
  }

  private say(notice: Notice | null): void {
    this.notice = notice;
    this.changed();
  }
}
