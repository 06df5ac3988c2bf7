import {updateLiveRegions} from './live-regions.js';
import {subscribe} from './event-stream.js';

/** What the page shows is out of date while the server is not heard, and is marked so. */
function showConnection(connection) {
  const isLive = connection === 'live';
  document.body.classList.toggle('outdated', !isLive);
  const banner = document.getElementById('offline');
  for (const sentence of banner.children) {
    sentence.hidden = sentence.dataset.connection !== connection;
  }
  banner.hidden = isLive;
}

subscribe(updateLiveRegions, showConnection);
