/** The player with all algorithms and their elements, for any page. */
import '../floating-horizon/shows.js';
import '../player/player.js';
import '../warnock/shows.js';
import '../weiler-atherton/shows.js';
import '../zbuffer/shows.js';
import './start-engine.js';
