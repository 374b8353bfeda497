import { html } from 'lit';
import { defineShows } from '../algorithm/shows.js';
import { ofPolygons } from '../polygons/shows.js';
import './algorithm.js';
import './panel.js';

defineShows(['zbuffer'], {
  ...ofPolygons,
  state: (view) => html`<vidno-zbuffer .view=${view}></vidno-zbuffer>`,
  legend: ['scanline', 'edge', 'active', 'touched', 'chosen'],
});
