import { unheld } from '../run/packed.js';
import { download, fileName, isGzip } from '../base/file.js';
import type { Carried } from '../editor/live.js';
import { inEachLanguage } from '../language/language.js';
import { idOf } from '../lessons/lessons.js';
import type { Lesson, LessonTrace } from '../lessons/lessons.js';
import { isOnDisk, pageFile } from '../lessons/page-file.js';
import { sceneTitle } from '../lessons/run-name.js';
import { formatAddress } from '../reader/address.js';
import type { Setup } from '../reader/address.js';
import { sceneFile } from '../run/sketch.js';
import type { Reading } from './reading.js';
import type { Session } from './session.js';

/** Everything that an address describes: what is shown, how, and where. */
export interface Shared {
  readonly lessons: readonly Lesson[];
  readonly session: Session;
  readonly reading: Reading;
  readonly setup: Setup;
}

/** What no address can hold: the reader's own trace, or a scene that is too large. */
interface Own {
  readonly run: LessonTrace;
  readonly file: Blob;
}

const written = (
  { session, reading, setup }: Shared,
  live: Carried | null,
  trace: string | null,
): string => {
  const { place, rival, witness, entry } = session;
  const lesson = reading.lesson?.story === undefined ? null : reading.lesson.id;
  const at = reading.reached.place;
  const isHeld = session.trace === null || trace !== null || entry !== null || live !== null;
  return formatAddress({
    setup,
    ...place,
    lesson,
    at,
    trace: isHeld ? trace : unheld,
    entry,
    // An entry of the atlas includes its scene.
    live: entry === null ? live : null,
    rival: rival.word,
    witness: witness.word,
  });
};

/** The address of what is shown, if it is known at once. */
export function addressNow(page: Shared): string | null {
  const { entry, live: now } = page.session;
  const live = entry === null ? now.carriedNow : null;
  return live === undefined ? null : written(page, live, page.session.lesson);
}

/**
 * The address of what is shown. If the page is saved with content that no address can hold, the address names that content.
 */
export async function addressOf(page: Shared, own: Own | null = null): Promise<string> {
  const { session } = page;
  return written(page, await session.live.carried(), own === null ? session.lesson : idOf(own.run));
}

/**
 * Copies the address of what is shown. Where an address cannot hold it, says so if the reader expects a link, and otherwise saves
 * a page that contains it.
 */
export async function share(page: Shared): Promise<void> {
  const { session } = page;
  const own = await ownOf(session);
  if (own === null && !isOnDisk()) {
    const address = new URL(await addressOf(page), location.href);
    await navigator.clipboard.writeText(address.href);
    session.live.tell('copied');
  } else if (own !== null && session.isLinked && session.live.link !== 'tooLong' && !isOnDisk()) {
    session.live.tell('tooLong');
  } else await savePage(page, own);
}

async function ownOf({ lesson, live, trace, file, entry }: Session): Promise<Own | null> {
  if (lesson !== null || trace === null || entry !== null) return null;
  if (file !== null) {
    const { method, edition, kernel, detail } = trace.header;
    const run = { file: 'own.jsonl.gz', method, edition, kernel, detail };
    return { run, file: (await isGzip(file)) ? file : await gzipped(file) };
  }
  if (live.editing === null || (await live.carried()) !== null) return null;
  const { sketch, options } = live.editing;
  return { run: { file: 'own.json', ...options }, file: new Blob([sceneFile(sketch)]) };
}

function gzipped(file: Blob): Promise<Blob> {
  return new Response(file.stream().pipeThrough(new CompressionStream('gzip'))).blob();
}

async function savePage(page: Shared, own: Own | null): Promise<void> {
  const { lessons, session, reading } = page;
  const { lesson, rival, trace, name, place, live } = session;
  if (trace === null) return;
  const runs = [lesson, rival.word];
  const needed = lessons.filter(
    (each) =>
      (each === reading.lesson && each.story !== undefined) ||
      each.traces.some((run) => runs.includes(idOf(run))),
  );
  const content = {
    lessons: own === null ? needed : [...needed, lessonOf(own, name)],
    own: new Map(own === null ? [] : [[own.run.file, own.file]]),
    address: await addressOf(page, own),
  };
  const { scene, method, kernel, edition } = trace.header;
  const file = fileName(scene.name, method, kernel, edition, `step-${place.step}`);
  download(await pageFile(document, content), `${file}.html`);
  live.tell('saved');
}

const lessonOf = ({ run }: Own, name: string): Lesson => ({
  id: run.file,
  title: inEachLanguage((language) => sceneTitle(language, name)),
  traces: [run],
});
