/** Tests need the algorithms, as the page does. */
import '../floating-horizon/algorithm.js';
import '../warnock/algorithm.js';
import '../weiler-atherton/algorithm.js';
import '../zbuffer/algorithm.js';
