import './shows.js';
import './start-engine.js';
import './app.js';
