/** What the runs of each algorithm hold. */
import '../floating-horizon/model.js';
import '../warnock/model.js';
import '../weiler-atherton/model.js';
import '../zbuffer/model.js';
