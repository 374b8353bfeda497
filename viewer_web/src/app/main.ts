import './shows.js';
import './app.js';
