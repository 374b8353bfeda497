/** Replays a trace of vidno (`vidno trace SCENE -o run.jsonl`). Importing the module defines the element. */
export interface VidnoPlayer extends HTMLElement {
  /** The address of a trace, `.jsonl` or `.jsonl.gz`, or `#id` of a block `<script type="application/jsonl">` in the page. */
  src: string;
  /** The step that is shown. An event `vidno-step` reports a new one. */
  step: number;
  /** The first and the last step that the reader can reach; `null` is the last of the trace. */
  from: number;
  to: number | null;
  /** Steps per second; `null` for the usual speed. */
  speed: number | null;
  /** Whether it starts to play at once. */
  play: boolean;
  controls: 'full' | 'small' | 'none';
  /** When questions are asked; empty for never. */
  ask: 'free' | 'forced' | '';
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-player': VidnoPlayer;
  }
}

export {};
