import { percentOf, readScore, shortScore } from '../predict/keeper.js';
import type { Keeper } from '../predict/keeper.js';
import type { Score } from '../predict/score.js';

const functions = [
  'LMSInitialize',
  'LMSGetValue',
  'LMSSetValue',
  'LMSCommit',
  'LMSFinish',
] as const;
type Name = (typeof functions)[number];

/** The functions of SCORM 1.2 by which a learning management system serves the pages that it shows. */
type Api = Readonly<Record<Name, (...texts: readonly string[]) => unknown>>;

function isApi(value: unknown): value is Api {
  const api = Object(value) as Readonly<Record<string, unknown>>;
  return functions.every((name) => typeof api[name] === 'function');
}

/** What the page reads of a window. */
export interface Frame {
  readonly parent: Frame;
  readonly opener: Frame | null;
}

/** How many windows around a window are searched, as in SCORM's own sample. */
const mostFrames = 7;

/** The functions that this window or one around it offers. A window of another origin lets nothing be read but its parent. */
function apiAround(frame: Frame, most = mostFrames): Api | null {
  try {
    const { API } = frame as Frame & { readonly API?: unknown };
    if (isApi(API)) return API;
  } catch {
    // The search goes on around it.
  }
  return most === 0 || frame.parent === frame ? null : apiAround(frame.parent, most - 1);
}

function apiFor(frame: Frame): Api | null {
  return apiAround(frame) ?? (frame.opener === null ? null : apiAround(frame.opener));
}

/** The most characters that a learning management system must keep for a page. */
const mostKept = 4096;

/**
 * The learning management system that shows the page as a lesson of SCORM 1.2. It has the percentage of `percentOf` as the score, and
 * keeps the score for the next visit. The lesson is completed once as many questions are answered as its launch data says.
 */
export class LearningSystem implements Keeper {
  readonly earlier: Score | null;
  percent: number | null = null;
  left: number;
  private readonly wanted: number;

  constructor(private readonly api: Api) {
    const isOpen = this.does('LMSInitialize', '');
    this.earlier = readScore(this.value('cmi.suspend_data'));
    this.wanted = Math.max(1, Number.parseInt(this.value('cmi.launch_data'), 10) || 1);
    const { total } = this.earlier ?? {};
    this.left = this.leftAfter(total?.asked ?? 0);
    const isDone = ['completed', 'passed'].includes(this.value('cmi.core.lesson_status'));
    const isBegun = isDone || this.sets('cmi.core.lesson_status', 'incomplete');
    // Only a suspended lesson keeps its data.
    const isKept = this.sets('cmi.core.exit', 'suspend') && this.does('LMSCommit', '');
    if (isOpen && isBegun && isKept) this.percent = total ? percentOf(total, this.wanted) : 0;
  }

  keep(score: Score): void {
    const { total } = score;
    const percent = percentOf(total, this.wanted);
    this.left = this.leftAfter(total.asked);
    const done = [
      this.sets('cmi.core.score.min', '0'),
      this.sets('cmi.core.score.max', '100'),
      this.sets('cmi.core.score.raw', String(percent)),
      this.left > 0 || this.sets('cmi.core.lesson_status', 'completed'),
      this.sets('cmi.suspend_data', shortScore(score, mostKept)),
      this.does('LMSCommit', ''),
    ];
    this.percent = done.every(Boolean) ? percent : null;
  }

  finish(): void {
    this.does('LMSFinish', '');
  }

  private leftAfter(asked: number): number {
    return Math.max(0, this.wanted - asked);
  }

  private value(element: string): string {
    const value = this.call('LMSGetValue', element);
    return typeof value === 'string' ? value : '';
  }

  private sets(element: string, value: string): boolean {
    return this.does('LMSSetValue', element, value);
  }

  private does(name: Name, ...texts: readonly string[]): boolean {
    return String(this.call(name, ...texts)) === 'true';
  }

  /** Nothing that the system does wrong may stop the page. */
  private call(name: Name, ...texts: readonly string[]): unknown {
    try {
      return this.api[name](...texts);
    } catch {
      return null;
    }
  }
}

/** The learning management system that shows this page, until the page is left; null if there is none. */
export function learningSystemOf(page: Frame & EventTarget): LearningSystem | null {
  const api = apiFor(page);
  if (api === null) return null;
  const system = new LearningSystem(api);
  page.addEventListener('pagehide', () => system.finish());
  return system;
}
