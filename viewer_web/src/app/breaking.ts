import { runs } from '../run/options.js';
import type { Options } from '../run/options.js';
import { deviationOf } from '../trace/editions.js';
import type { Deviation, Edition } from '../trace/editions.js';
import type { Layer } from '../picture/layers.js';
import type { Shown } from './stage.js';

/** How the run beside the open one is broken; null for any other run. */
export function brokenBeside({ trace, rival }: Shown['session']): Deviation | null {
  const { chosen } = rival;
  if (trace === null || chosen?.kind !== 'run') return null;
  const { method, edition, kernel } = chosen.options;
  const { header } = trace;
  const isElseSame =
    header.method === method && header.edition === 'corrected' && header.kernel === kernel;
  return isElseSame ? deviationOf(edition) : null;
}

/** Breaks a line of the open run, and repairs it. */
export class Breaking {
  /** Whether to show the first difference as soon as it is known. */
  seeks = false;
  /** The step and layer before the line was broken here. */
  private before: { readonly step: number; readonly layer: Layer } | null = null;

  constructor(private readonly page: Shown) {}

  /** Runs the open scene with a broken line, and goes to the first visible difference. */
  break(edition: Edition): void {
    const { session, setup, ways } = this.page;
    const { trace, rival, place, witness } = session;
    if (trace === null) return;
    const { method, kernel, detail } = trace.header;
    const options: Options = { method, edition, kernel, detail, check: false };
    if (!runs(options)) return;
    ways.leave();
    if (rival.chosen === null) this.before = { step: place.step, layer: setup.layer };
    this.seeks = true;
    witness.close();
    rival.choose({ kind: 'run', options });
    this.page.change({ layer: 'difference' });
  }

  /** Opens the smallest scene that shows the broken line, leaves it, or returns to the right run. */
  follow(way: string): void {
    const { session, ways } = this.page;
    const { chosen } = session.rival;
    if (way === 'smallest' && chosen?.kind === 'run') {
      ways.leave();
      this.seeks = true;
      session.witness.open(chosen.options);
    } else if (way === 'own') {
      ways.leave();
      session.witness.close();
      session.move({});
    } else this.leave();
  }

  /** Shows the smallest scene at a step, as given in an address; null closes it. */
  openAt(step: number | null): void {
    const { witness, rival } = this.page.session;
    const options = rival.chosen?.kind === 'run' ? rival.chosen.options : null;
    const isThere = witness.edition === options?.edition && witness.place.step === step;
    if (step === null || options === null) witness.close();
    else if (!isThere) witness.open(options, step);
  }

  /** Called when the first difference was found, or there is none. */
  found(): void {
    this.seeks = false;
    this.page.requestUpdate();
  }

  /** Closes the other run. If it was broken here, restores the previous step and layer. */
  leave(): void {
    const { session, ways } = this.page;
    const { before } = this;
    ways.leave();
    const wasBroken = brokenBeside(session) !== null;
    this.before = null;
    this.seeks = false;
    session.witness.close();
    session.rival.choose(null);
    if (!wasBroken) return;
    this.page.change({ layer: before?.layer ?? 'picture' });
    if (before !== null) session.move({ step: before.step });
  }
}
