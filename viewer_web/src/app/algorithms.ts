/** Registers all algorithms, without the elements that show their runs. */
import '../floating-horizon/algorithm.js';
import '../warnock/algorithm.js';
import '../weiler-atherton/algorithm.js';
import '../zbuffer/algorithm.js';
