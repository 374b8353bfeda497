/** What is tested needs the algorithms, as the page does. */
import '../app/algorithms.js';
