import {showCameras} from '../shared/cameras.js';
import '../shared/live.js';

showCameras();
