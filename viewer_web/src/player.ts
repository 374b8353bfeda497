import './components/player.js';
