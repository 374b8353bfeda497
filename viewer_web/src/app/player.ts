import '../player/player.js';
import './shows.js';
import './start-engine.js';
