import { html, nothing, svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import { defineShows } from '../algorithm/shows.js';
import type { LegendEntry } from '../language/texts.js';
import type { Pixel } from '../picture/pixel.js';
import './algorithm.js';
import './curve-picture.js';
import { allLayers } from './shapes.js';
import type { Layer } from './shapes.js';
import './panel.js';
import './surface-form.js';

const line = 'M1.5 10L18.5 4';

/** The icon of each entry, in a box of 20 by 14. */
const icons = {
  visible: ['visible', line],
  current: ['current', line],
  upper: ['upper', 'M1 7h18'],
  lower: ['lower', 'M1 7h18'],
  above: ['flag above', 'M6 10h8l-4 -7Z'],
  below: ['flag below', 'M6 4h8l-4 7Z'],
  hidden: ['flag hidden', 'M6.5 7a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0Z'],
  sideEdge: ['side-edge', line],
} as const satisfies Partial<Record<LegendEntry, readonly [look: string, d: string]>>;

type CurveLegendEntry = keyof typeof icons;

/** In the order of the legend. */
const curveEntries = Object.keys(icons) as readonly CurveLegendEntry[];

const isCurveEntry = (entry: LegendEntry): entry is CurveLegendEntry => entry in icons;

function curveIcon(entry: CurveLegendEntry): SVGTemplateResult {
  const [look, d] = icons[entry];
  return svg`<path class=${look} d=${d} />`;
}

defineShows(['floating-horizon'], {
  state: (view, parts) =>
    html`<vidno-horizon
      .view=${view}
      ?hall=${view.hall}
      parts=${parts?.join(' ') ?? nothing}
    ></vidno-horizon>`,
  holds: () => ['curve', 'side-edges', 'horizons'],
  legend: curveEntries,
  icon: (entry) => (isCurveEntry(entry) ? curveIcon(entry) : null),
  picture: (of) => {
    const shown = of.shownOf(allLayers);
    return html`<vidno-curve-picture
        class="drawing"
        .view=${of.view}
        .layers=${shown}
        ?edited=${of.editing !== null}
        @pixel=${({ detail }: CustomEvent<Pixel>) => of.choose(detail)}
      ></vidno-curve-picture>
      <vidno-curve-layers
        class="layers"
        .view=${of.view}
        .layers=${shown}
        @layers=${({ detail }: CustomEvent<ReadonlySet<Layer>>) => of.show(detail, allLayers)}
      ></vidno-curve-layers>`;
  },
  places: ({ history, curves }) => ({ ...history, ...curves.history }),
  form: (editing, language) =>
    html`<vidno-surface-form .editing=${editing} .language=${language}></vidno-surface-form>`,
  how: ({ curves }) => curves.surface.how,
  isSolid: false,
});
