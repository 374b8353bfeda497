import './app.js';
import './player.js';
