/** Registers all algorithms with their elements. */
import '../floating-horizon/shows.js';
import '../warnock/shows.js';
import '../weiler-atherton/shows.js';
import '../zbuffer/shows.js';
