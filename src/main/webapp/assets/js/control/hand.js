import {setText} from '../shared/elements.js';
import {address, send} from '../shared/server.js';
import {text} from '../shared/texts.js';

/** Milliseconds between two orders while a button is pressed: without them the robot stands. */
const INTERVAL = 100;

/** The same while none is: so that the robot stays this person's. */
const IDLE_INTERVAL = 3_000;

/** How the robot goes for each way: shares of its speed and of its turn rate. */
const WAYS = {forward: [1, 0], back: [-1, 0], left: [0, 1], right: [0, -1]};

const KEYS = {
  ArrowUp: 'forward', KeyW: 'forward', ArrowDown: 'back', KeyS: 'back',
  ArrowLeft: 'left', KeyA: 'left', ArrowRight: 'right', KeyD: 'right',
};

/**
 * Drives a robot by hand: as long as a button or a key is pressed it is told so again and again,
 * and stands when that ends, for whatever reason.
 */
export class Hand {
  #path;
  #speed;
  #turnRate;
  #driver = null; // who drives it, as the fleet says
  #lease; // undefined: this page does not drive it
  #number = 0;
  #pressed = new Set(); // ways
  #isTaking = false;
  #isRunning = false;
  #wake = () => {};

  constructor(card, {robot, speed, turnRate}) {
    this.#path = `api/v1/robots/${encodeURIComponent(robot)}/drive`;
    this.#speed = Number(speed);
    this.#turnRate = Number(turnRate);
    this.$ = (selector) => card.querySelector(selector);
    this.$('#take').addEventListener('click', () => this.#take());
    this.$('#leave').addEventListener('click', () => this.#leave());
    for (const button of card.querySelectorAll('[data-way]')) {
      this.#listenTo(button);
    }
    addEventListener('keydown', (event) => this.#keyDown(event));
    addEventListener('keyup', (event) => this.#release(KEYS[event.code]));
    addEventListener('blur', () => this.#releaseAll());
    document.addEventListener('visibilitychange', () => this.#releaseAll());
    addEventListener('pagehide', () => this.#abandon());
  }

  /** @param robot as the live stream has it */
  update({name, driver}) {
    this.#driver = driver;
    this.#showDriver(name);
  }

  #showDriver(robot) {
    const isOthers = this.#driver !== null && !this.#lease;
    this.$('#driver').hidden = !isOthers;
    if (isOthers) {
      setText(this.$('#driver'), text('control.hand.busy', this.#driver, robot));
    }
    this.$('#take').disabled = isOthers;
  }

  #listenTo(button) {
    const {way} = button.dataset;
    if (way === 'stop') {
      button.addEventListener('click', () => this.#releaseAll());
      return;
    }
    button.addEventListener('pointerdown', (event) => {
      if (event.button === 0) {
        button.setPointerCapture(event.pointerId);
        this.#press(way);
      }
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      button.addEventListener(end, () => this.#release(way));
    }
    button.addEventListener('contextmenu', (event) => event.preventDefault()); // a long touch
    button.addEventListener('keydown', (event) => {
      if (event.code === 'Space' || event.code === 'Enter') {
        event.preventDefault();
        this.#press(way);
      }
    });
    button.addEventListener('keyup', () => this.#release(way));
    button.addEventListener('blur', () => this.#release(way));
  }

  #keyDown(event) {
    if (!this.#lease || event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    if (event.code === 'Escape') {
      this.#leave();
    } else if (KEYS[event.code]) {
      event.preventDefault(); // the page would scroll
      this.#press(KEYS[event.code]);
    }
  }

  async #take() {
    if (this.#isTaking) {
      return; // of two clicks the second would be told that the first drives it
    }
    this.#isTaking = true;
    this.#say('');
    const isTaken = await this.#order(0, 0);
    this.#isTaking = false;
    if (isTaken) {
      this.#show();
      this.$('[data-way="forward"]').focus();
      this.#keepOn();
    }
  }

  #press(way) {
    if (this.#lease && !this.#pressed.has(way)) {
      this.#pressed.add(way);
      this.#mark();
      this.#wake();
    }
  }

  #release(way) {
    if (this.#pressed.delete(way)) {
      this.#mark();
      if (this.#pressed.size === 0) {
        this.#order(0, 0); // at once, beside whatever is under way
      }
    }
  }

  #releaseAll() {
    [...this.#pressed].forEach((way) => this.#release(way));
  }

  #mark() {
    for (const button of this.$('#pad').querySelectorAll('[data-way]')) {
      button.classList.toggle('pressed', this.#pressed.has(button.dataset.way));
    }
  }

  /** Tells the robot what is pressed, as long as this page drives it. */
  async #keepOn() {
    if (this.#isRunning) {
      return;
    }
    this.#isRunning = true;
    while (this.#lease) {
      const begun = performance.now();
      const [speed, turnRate] = this.#wanted();
      const isIdle = this.#pressed.size === 0;
      if (!(await this.#order(speed, turnRate))) {
        break;
      }
      if (isIdle && this.#pressed.size === 0) {
        await this.#sleep(IDLE_INTERVAL);
      } else {
        await new Promise((resolve) => setTimeout(resolve, INTERVAL - (performance.now() - begun)));
      }
    }
    this.#isRunning = false;
    this.#show();
  }

  /** Until the time is over or a button is pressed. */
  #sleep(milliseconds) {
    return new Promise((resolve) => {
      const timer = setTimeout(resolve, milliseconds);
      this.#wake = () => {
        clearTimeout(timer);
        resolve();
      };
    });
  }

  #wanted() {
    const ways = [...this.#pressed].map((way) => WAYS[way]);
    const sum = (index) => Math.min(1, Math.max(-1, ways.reduce((total, way) => total + way[index], 0)));
    const [forward, turn] = [sum(0), sum(1)];
    // backward the wheel is turned the other way, as in a car
    return [forward * this.#speed, (forward < 0 ? -turn : turn) * this.#turnRate];
  }

  /** Whether this page still drives the robot. */
  async #order(v, w) {
    const {status, body} = await send('POST', this.#path, {lease: this.#lease ?? null, number: ++this.#number, v, w});
    if (status === 200) {
      this.#lease = body.lease;
      this.#say(v === 0 && w === 0 ? '' : (body.refusal ?? ''));
      return true;
    }
    if (status === 0 || status === 429 || status === 503) {
      this.#say(text('control.hand.noAnswer'));
      return this.#lease !== undefined; // it stands by itself, and may go on later
    }
    this.#lease = undefined;
    this.#pressed.clear();
    this.#mark();
    this.#show();
    this.#say(body?.detail ?? text('control.hand.ended'));
    return false;
  }

  async #leave() {
    const lease = this.#lease;
    this.#lease = undefined;
    this.#pressed.clear();
    this.#mark();
    this.#wake();
    this.#show();
    this.#say('');
    this.$('#take').focus();
    if (lease) {
      await send('DELETE', `${this.#path}?lease=${lease}`);
    }
  }

  /** The page is closed: the robot stands anyway, but is anybody's at once if this still arrives. */
  #abandon() {
    if (this.#lease) {
      send('DELETE', `${this.#path}?lease=${this.#lease}`);
      this.#lease = undefined;
    }
  }

  #show() {
    const isDriving = this.#lease !== undefined;
    this.$('#take').hidden = isDriving;
    this.$('#pad').hidden = !isDriving;
    this.$('#leave').hidden = !isDriving;
  }

  #say(sentence) {
    this.$('#hand-says').hidden = sentence === '';
    setText(this.$('#hand-says'), sentence);
  }
}
