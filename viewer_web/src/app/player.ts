import '../player/player.js';
import './shows.js';
