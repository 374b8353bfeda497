import { html, nothing } from 'lit';
import { defineShows } from '../algorithm/shows.js';
import { ofPolygons } from '../polygons/shows.js';
import './algorithm.js';
import './panel.js';

defineShows(['zbuffer'], {
  ...ofPolygons,
  state: (view, parts) =>
    html`<vidno-zbuffer
      .view=${view}
      ?hall=${view.hall}
      parts=${parts?.join(' ') ?? nothing}
    ></vidno-zbuffer>`,
  holds: ({ after: { zbuffer } }) => [
    'scanline',
    'z-buffer',
    ...(zbuffer?.ael.length ? (['active-edges'] as const) : []),
  ],
  legend: ['scanline', 'edge', 'active', 'touched', 'chosen'],
});
