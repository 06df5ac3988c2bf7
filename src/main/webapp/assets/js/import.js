import './live.js';
import './zone.js';
