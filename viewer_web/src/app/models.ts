/** Registers the model of each algorithm. */
import '../floating-horizon/model.js';
import '../warnock/model.js';
import '../weiler-atherton/model.js';
import '../zbuffer/model.js';
