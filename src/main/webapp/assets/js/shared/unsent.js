import {address} from './server.js';

/** Milliseconds for which a server that was heard is taken to be there. */
const FRESH = 20_000;
/** Milliseconds in which it says that it is there, or is not heard. */
const PATIENCE = 5_000;

const banner = document.getElementById('offline');
let heardAt = performance.now(); // the page has just come
let pressed; // the last press, which alone counts, as it does where nobody asks

/**
 * A form with entries is sent only to a server that is there: else the browser would show its own page, and they were
 * gone. One without has nothing to lose, and is sent at once: what stops robots must not wait.
 */
document.addEventListener('submit', async (event) => {
  const form = event.target;
  if (event.defaultPrevented || form.method !== 'post') {
    return;
  }
  pressed = event;
  if (!form.querySelector('input:not([type=hidden]), select, textarea') || performance.now() - heardAt < FRESH) {
    return;
  }
  event.preventDefault();
  const {submitter} = event;
  if (!(await isHeard())) {
    showUnsent();
    return;
  }
  heardAt = performance.now();
  if (pressed === event) {
    submit(form, submitter);
  }
});

function submit(form, submitter) {
  if (!form.isConnected) { // its live region was replaced meanwhile
    form.hidden = true;
    for (const element of form.querySelectorAll('[id]')) {
      element.removeAttribute('id'); // what has taken its place bears it
    }
    document.body.append(form);
  }
  form.requestSubmit(submitter);
}

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
  banner.parentElement.prepend(banner); // it answers what was just pressed
  banner.scrollIntoView({block: 'nearest'});
}
