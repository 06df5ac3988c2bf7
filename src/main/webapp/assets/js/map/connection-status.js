import {createElement, setText} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {address} from '../shared/server.js';
import {text} from '../shared/texts.js';

const whole = new Intl.NumberFormat(locale);
const $ = (selector) => document.querySelector(selector);

/** Says whether the map is live, how old its data are, and what is wrong with the connection. */
export class ConnectionStatus {
  #connection; // undefined until it is known
  #updatedAt = performance.now(); // milliseconds
  #isReplay;

  /** @param isReplay answers whether the page shows a replay */
  constructor(isReplay) {
    this.#isReplay = isReplay;
    setInterval(() => this.show(), 1_000);
  }

  markUpdated(now) {
    this.#updatedAt = now;
  }

  show() {
    if (!this.#connection) {
      return; // the page says that it connects
    }
    const age = $('#age');
    const isReplay = this.#isReplay();
    age.dataset.state = isReplay ? 'replay' : this.#connection;
    if (isReplay) {
      setText(age, text('replay.label'));
    } else if (this.#connection === 'live') {
      const seconds = Math.round((performance.now() - this.#updatedAt) / 1000);
      setText(age, `${text('map.live')} · ${text('map.age', whole.format(seconds))}`);
    } else {
      setText(age, '');
    }
  }

  /** @param connection 'live', 'disconnected' or 'loggedOut' */
  change(connection) {
    this.#connection = connection;
    const isLive = connection === 'live';
    document.body.classList.toggle('outdated', !isLive);
    this.show();
    const banner = $('#banner');
    banner.hidden = isLive;
    if (isLive) {
      $('#offline').hidden = true; // what was not sent can be sent again
    } else {
      banner.replaceChildren(text(`map.${connection}`));
    }
    if (connection === 'loggedOut') {
      const link = createElement('a', '', text('map.loggedOut.link'));
      link.href = address('?next=/map');
      banner.append(' ', link);
    }
  }

  showLoadFailure() {
    $('#banner').hidden = false;
    $('#banner').textContent = text('map.failed');
  }
}
