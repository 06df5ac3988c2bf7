import {changed} from './changes.js';
import {address, fetchJson} from './server.js';

/** Longer than the server is ever silent, in milliseconds. */
const SILENCE = 12_000;
const RETRY = 2_000;

/**
 * Follows the fleet's live events and comes back after every loss.
 *
 * @param onSnapshot called with each snapshot
 * @param onConnection called with 'live', 'away' or 'loggedOut' when that changes
 */
export function follow(onSnapshot, onConnection = () => {}) {
  let state = '';
  let heard = performance.now();
  let source;
  let snapshot;

  const say = (next) => {
    if (next !== state) {
      state = next;
      onConnection(next);
    }
  };
  const hear = () => {
    heard = performance.now();
    say('live');
  };
  const show = (next) => {
    hear();
    snapshot = next;
    onSnapshot(next);
  };
  /** The browser comes back by itself after a broken line, and says which event it had last. */
  const lose = () => {
    say('away');
    if (source.readyState === EventSource.CLOSED) {
      reopen();
    }
  };
  const reopen = async () => {
    heard = performance.now();
    source.close();
    say('away');
    try {
      await fetchJson('api/v1/robots');
    } catch (error) {
      if (error.status === 401) {
        say('loggedOut');
        return;
      }
    }
    setTimeout(open, RETRY);
  };
  const open = () => {
    source?.close();
    heard = performance.now();
    source = new EventSource(address('api/v1/events?changes=true'));
    source.addEventListener('snapshot', (event) => show(JSON.parse(event.data)));
    source.addEventListener('change', (event) => show(changed(snapshot, JSON.parse(event.data))));
    source.addEventListener('alive', hear);
    source.addEventListener('error', lose);
  };

  open();
  setInterval(() => {
    if (state !== 'loggedOut' && performance.now() - heard > SILENCE) {
      reopen();
    }
  }, 1_000);
  addEventListener('pagehide', () => source.close());
}
