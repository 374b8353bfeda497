import { html, nothing, svg } from 'lit';
import type { SVGTemplateResult, TemplateResult } from 'lit';
import { toNumber } from '../language/words.js';
import type { Numbers, WhyTexts } from '../language/texts.js';

/** The depth of a polygon's plane at the centre of a pixel. */
export interface Depth {
  readonly id: string;
  readonly color: string;
  readonly depth: string;
  /** Whether the polygon itself is there. */
  readonly holds: boolean;
}

/** What the column compares: the owner with another polygon, among all depths there. */
export interface Compared {
  readonly owner: Depth;
  readonly other: Depth;
  /** By how much the owner is nearer. */
  readonly gap?: string | undefined;
  readonly all: readonly string[];
}

/** CSS pixels. A label has two lines; the gap is between two labels. */
const size = { width: 88, height: 132 };
const scale = { top: 20, bottom: 124 };
const labels = { top: 28, bottom: 118, apart: 42 };
const mostLetters = 7;

export interface Place {
  readonly at: number;
  readonly label: number;
}

/** The middle of two labels that do not overlap, near the upper and the lower place. */
function apart(upper: number, lower: number): readonly [number, number] {
  const within = (at: number, end: number): number => Math.min(Math.max(at, labels.top), end);
  const places = [within(upper, labels.bottom), within(lower, labels.bottom)] as const;
  const [first, last] = places;
  if (last - first >= labels.apart) return places;
  const start = within((first + last - labels.apart) / 2, labels.bottom - labels.apart);
  return [start, start + labels.apart];
}

/** Where the depths and their labels are, the nearest depth on top, and the places of all depths. */
export function heightsOf({ owner, other, all }: Compared): {
  readonly owner: Place;
  readonly other: Place;
  readonly all: readonly number[];
} {
  const depths = [owner.depth, other.depth, ...all].map(toNumber);
  const [nearest, farthest] = [Math.max(...depths), Math.min(...depths)];
  const range = nearest - farthest;
  const share = (depth: number): number => (range === 0 ? 0.5 : (nearest - depth) / range);
  const [one = 0, two = 0, ...rest] = depths.map(
    (depth) => scale.top + share(depth) * (scale.bottom - scale.top),
  );
  const [upper, lower] = apart(Math.min(one, two), Math.max(one, two));
  const isOver = one <= two;
  return {
    owner: { at: one, label: isOver ? upper : lower },
    other: { at: two, label: isOver ? lower : upper },
    all: rest,
  };
}

const clipped = (id: string): string => {
  const letters = Array.from(id);
  return letters.length > mostLetters ? `${letters.slice(0, mostLetters - 1).join('')}…` : id;
};

function labelled(
  { id, color, depth, holds }: Depth,
  { at, label }: Place,
  { short }: Numbers,
): SVGTemplateResult {
  return svg`<path class=${holds ? 'tick' : 'tick plane'} d="M3 ${at}H20" />
    <path class="leader" d="M20 ${at}L27 ${label}" />
    <rect class="color" x="29" y=${label - 10} width="8" height="8" .style=${`fill: ${color}`} />
    <text class="id" x="40" y=${label - 2}>${clipped(id)}</text>
    <text x="29" y=${label + 10}>${short(depth)}</text>`;
}

/** The depths of the owner of a pixel and of another polygon on one vertical scale, and the gap between them. */
export function depthColumn(compared: Compared, texts: WhyTexts, numbers: Numbers): TemplateResult {
  const { owner, other, gap } = compared;
  const places = heightsOf(compared);
  const [one, two] = [places.owner, places.other];
  const said = [owner, other].map(({ id, depth }) => `${id} ${numbers.inFull(depth)}`);
  return html`<svg
    class="column"
    viewBox="0 0 ${size.width} ${size.height}"
    role="img"
    aria-label=${texts.depths(numbers.joined(said))}
  >
    <text class="nearer" x="14" y="11">${texts.nearer}</text>
    <path class="axis" d="M8 130V6M4 11L8 5L12 11" />
    ${places.all.map((at) => svg`<path class="other" d="M5 ${at}H11" />`)}
    ${
      gap === undefined
        ? nothing
        : svg`<path class="gap" d="M16 ${one.at}V${two.at}" />
            <text class="gap" x="29" y=${(one.label + two.label) / 2 + 4}>${numbers.short(gap)}</text>`
    }
    ${labelled(owner, one, numbers)} ${labelled(other, two, numbers)}
  </svg>`;
}
