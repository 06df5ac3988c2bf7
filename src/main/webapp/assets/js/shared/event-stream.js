import {address, fetchJson} from './server.js';
import {applyChange} from './snapshot-changes.js';

/** Longer than the server is ever silent, in milliseconds. */
const SILENCE = 12_000;
/** Milliseconds until a connection is tried again. */
const RETRY = 2_000;

/**
 * Receives the fleet's live events, and connects again after every loss. When there are other notices, or may be, the
 * document gets the event 'toqa-notices'.
 *
 * @param onSnapshot called with each snapshot
 * @param onConnection called with 'live', 'disconnected' or 'loggedOut' when that changes
 */
export function subscribe(onSnapshot, onConnection = () => {}) {
  new EventStream(onSnapshot, onConnection).open();
}

class EventStream {
  #onSnapshot;
  #onConnection;
  #state = '';
  #heardAt = 0; // milliseconds of the page's clock
  #source;
  #snapshot;

  constructor(onSnapshot, onConnection) {
    this.#onSnapshot = onSnapshot;
    this.#onConnection = onConnection;
    setInterval(() => this.#checkSilence(), 1_000);
    addEventListener('pagehide', () => this.#source?.close());
  }

  open() {
    this.#source?.close();
    this.#heardAt = performance.now();
    const source = new EventSource(address('api/v1/events?changes=true&notices=true'));
    source.addEventListener('snapshot', (event) => this.#receive(JSON.parse(event.data)));
    source.addEventListener('change', (event) => this.#receive(applyChange(this.#snapshot, JSON.parse(event.data))));
    source.addEventListener('alive', () => this.#markAlive());
    source.addEventListener('open', () => document.dispatchEvent(new Event('toqa-notices')));
    source.addEventListener('notices', () => document.dispatchEvent(new Event('toqa-notices')));
    source.addEventListener('error', () => this.#handleLoss());
    this.#source = source;
  }

  #receive(snapshot) {
    this.#markAlive();
    this.#snapshot = snapshot;
    this.#onSnapshot(snapshot);
  }

  #markAlive() {
    this.#heardAt = performance.now();
    this.#setState('live');
  }

  #setState(state) {
    if (state !== this.#state) {
      this.#state = state;
      this.#onConnection(state);
    }
  }

  /** The browser reconnects by itself after a broken line, and says which event it had last. */
  #handleLoss() {
    this.#setState('disconnected');
    if (this.#source.readyState === EventSource.CLOSED) {
      this.#reopen();
    }
  }

  #checkSilence() {
    if (this.#state !== 'loggedOut' && performance.now() - this.#heardAt > SILENCE) {
      this.#reopen();
    }
  }

  async #reopen() {
    this.#heardAt = performance.now();
    this.#source.close();
    this.#setState('disconnected');
    try {
      await fetchJson('api/v1/robots');
    } catch (error) {
      if (error.status === 401) {
        this.#setState('loggedOut');
        return;
      }
    }
    setTimeout(() => this.open(), RETRY);
  }
}
