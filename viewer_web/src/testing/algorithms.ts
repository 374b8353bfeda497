/** Tests need the algorithms, as the page does. */
import '../app/algorithms.js';
