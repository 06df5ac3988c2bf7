import {write} from './entries.js';
import {locale} from './locale.js';
import {Past} from './past.js';
import {text} from './texts.js';

const HOUR = 3_600_000;
const STEP = 10_000; // milliseconds
/** A robot that moves leaves a point a minute, and it is stored ten seconds later. */
const STORED = 75_000;
const LOOK = 250; // milliseconds between two looks at the lists while it plays

const $ = (selector) => document.querySelector(selector);
const format = new Intl.DateTimeFormat(locale, {dateStyle: 'short', timeStyle: 'medium'});

/**
 * The bar by which the reader goes back in time and comes back: a slider, play and pause, and how
 * fast. Times are milliseconds since 1970.
 */
export class Replay {
  #newest;
  #floor;
  #onChange;
  #past;
  #end = 0;
  #moment = 0;
  #plays = false;
  #frame; // when it last went on
  #looked = 0;

  /**
   * @param newest tells the time at which live is
   * @param floor tells the name of the floor that is shown
   * @param onChange called when another moment is shown, or what is known of it has come
   */
  constructor(newest, floor, onChange) {
    this.#newest = newest;
    this.#floor = floor;
    this.#onChange = onChange;
    $('#replay-open').addEventListener('click', () => this.#open());
    $('#replay-live').addEventListener('click', () => this.#close());
    $('#replay-play').addEventListener('click', () => this.#play(!this.#plays));
    $('#replay-back').addEventListener('click', () => this.#goTo(this.#moment - STEP));
    $('#replay-on').addEventListener('click', () => this.#goTo(this.#moment + STEP));
    $('#replay-time').addEventListener('input', (event) => this.#goTo(event.target.valueAsNumber));
    $('#replay-hours').addEventListener('change', () => this.#measure());
  }

  get isOpen() {
    return this.#past !== undefined;
  }

  /** Whether what was at the moment shown is still on its way here. */
  get isLoading() {
    return !this.#past.has(this.#moment);
  }

  poseOf(robot) {
    return this.#past.poseOf(robot, this.#moment);
  }

  /** What had happened lately, newest first. */
  get events() {
    return this.#past.events(this.#moment);
  }

  /** Another floor is shown. */
  changeFloor() {
    if (this.isOpen) {
      this.#past = new Past(this.#floor(), this.#end, this.#onChange);
      this.#show();
    }
  }

  /**
   * Goes on to the moment that a frame shows.
   *
   * @param now of the frame, milliseconds
   * @returns whether the next frame shows another one
   */
  advance(now) {
    const since = now - (this.#frame ?? now);
    this.#frame = now;
    if (this.#plays && !this.isLoading) {
      this.#moment = Math.min(this.#end, this.#moment + since * Number($('#replay-speed').value));
      this.#play(this.#moment < this.#end);
      this.#look(now);
    }
    return this.#plays;
  }

  /** People and lists need not follow each frame. */
  #look(now) {
    if (!this.#plays || now - this.#looked >= LOOK) {
      this.#looked = now;
      this.#show();
    }
  }

  #open() {
    this.#end = this.#newest() - STORED;
    this.#past = new Past(this.#floor(), this.#end, this.#onChange);
    this.#moment = this.#end;
    $('#replay-time').max = this.#end;
    this.#measure();
    this.#showBar();
    $('#replay-time').focus();
  }

  #close() {
    this.#play(false);
    this.#past = undefined;
    this.#showBar();
    $('#replay-open').focus();
    this.#onChange();
  }

  #showBar() {
    $('#replay').hidden = !this.isOpen;
    $('#replay-open').hidden = this.isOpen;
    $('#replay-banner').hidden = !this.isOpen;
    $('#replay-failed').hidden = true;
  }

  /** How far back the slider reaches. */
  #measure() {
    const slider = $('#replay-time');
    slider.min = this.#end - Number($('#replay-hours').value) * HOUR;
    slider.step = STEP;
    this.#goTo(this.#moment);
  }

  #goTo(moment) {
    this.#moment = Math.min(this.#end, Math.max(Number($('#replay-time').min), moment));
    this.#show();
  }

  #play(plays) {
    if (plays === this.#plays) {
      return;
    }
    this.#plays = plays;
    this.#frame = undefined;
    write($('#replay-play'), text(plays ? 'replay.pause' : 'replay.play'));
    this.#show();
  }

  #show() {
    if (!this.isOpen) {
      return;
    }
    const slider = $('#replay-time');
    slider.valueAsNumber = this.#moment;
    const words = format.format(this.#moment);
    write($('#replay-moment'), words);
    if (!this.#plays || document.activeElement !== slider) {
      slider.ariaValueText = words; // while it plays, nobody wants to hear each second
    }
    $('#replay-play').disabled = this.#moment >= this.#end;
    this.#load();
    this.#onChange();
  }

  async #load() {
    const past = this.#past;
    let failed = false;
    try {
      await past.want(this.#moment);
    } catch {
      failed = true;
    }
    if (past === this.#past) {
      $('#replay-failed').hidden = !failed;
      this.#play(this.#plays && !failed);
    }
  }
}
