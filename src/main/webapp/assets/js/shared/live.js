import {updateLiveRegions} from './live-regions.js';
import {subscribe} from './event-stream.js';

subscribe(updateLiveRegions);
