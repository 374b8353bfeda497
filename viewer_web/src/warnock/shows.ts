import { html, nothing } from 'lit';
import { defineShows } from '../algorithm/shows.js';
import { ofPolygons } from '../polygons/shows.js';
import { hasWindows, methods } from '../trace/events.js';
import './algorithm.js';
import './panel.js';

defineShows(methods.filter(hasWindows), {
  ...ofPolygons,
  state: (view, parts) =>
    html`<vidno-warnock
      .view=${view}
      ?hall=${view.hall}
      parts=${parts?.join(' ') ?? nothing}
    ></vidno-warnock>`,
  holds: ({ header, after: { warnock } }) => [
    'window',
    'corner-depths',
    ...(header.detail !== 'windows' && warnock?.apl ? (['active-polygons'] as const) : []),
    ...(warnock?.stack.length ? (['stack'] as const) : []),
  ],
  legend: ['window', 'way', 'tree', 'stacked', 'active', 'touched', 'yes', 'no', 'chosen'],
});
