import '../player/player.js';
