/** Registers all algorithms without their elements, for the program of questions and for tests. */
import '../floating-horizon/algorithm.js';
import '../warnock/algorithm.js';
import '../weiler-atherton/algorithm.js';
import '../zbuffer/algorithm.js';
