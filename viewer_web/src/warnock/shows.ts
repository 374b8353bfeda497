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
  legend: ['window', 'way', 'tree', 'stacked', 'active', 'touched', 'yes', 'no', 'chosen'],
});
