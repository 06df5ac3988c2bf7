import {address} from './server.js';

/** Milliseconds for which a server that was heard is taken to be there. */
const FRESH = 20_000;
/** Milliseconds in which it says that it is there, or is not heard. */
const PATIENCE = 5_000;

const banner = document.getElementById('offline');
let heardAt = performance.now(); // the page has just come
let isAsking = false;

/** A form is sent only to a server that is there: else the browser would show its own page, and the entries were gone. */
document.addEventListener('submit', async (event) => {
  const form = event.target;
  if (event.defaultPrevented || form.method !== 'post' || performance.now() - heardAt < FRESH) {
    return;
  }
  event.preventDefault();
  if (isAsking) {
    return;
  }
  isAsking = true;
  const isThere = await isHeard();
  isAsking = false;
  if (isThere) {
    heardAt = performance.now();
    form.requestSubmit(event.submitter);
  } else {
    showUnsent();
  }
});

/** Whatever it answers. */
async function isHeard() {
  try {
    await fetch(address('api/v1/health'), {
      cache: 'no-store',
      headers: {'x-toqa-background': 'yes'},
      signal: AbortSignal.timeout(PATIENCE),
    });
    return true;
  } catch {
    return false;
  }
}

function showUnsent() {
  for (const sentence of banner.children) {
    sentence.hidden = sentence.dataset.connection !== 'unsent';
  }
  banner.hidden = false;
  banner.scrollIntoView({block: 'nearest'});
}
