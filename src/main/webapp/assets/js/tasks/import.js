import '../shared/live.js';
import '../shared/time-zone.js';
