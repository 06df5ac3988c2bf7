import {showParts} from './parts.js';
import {follow} from './stream.js';

follow(showParts);
