import {setText} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';
import {ReplayData} from './replay-data.js';

const HOUR = 3_600_000; // milliseconds
const STEP = 10_000; // milliseconds
/** A moving robot records a point at least once a minute, and it is stored ten seconds later. */
const STORAGE_DELAY = 75_000;
const LIST_INTERVAL = 250; // milliseconds between two updates of the lists while it plays

const $ = (selector) => document.querySelector(selector);
const format = new Intl.DateTimeFormat(locale, {dateStyle: 'short', timeStyle: 'medium'});

/** The replay's controls: a slider, play and pause, and the speed. Times are milliseconds since 1970. */
export class Replay {
  #liveTime;
  #floorName;
  #onChange;
  #data; // undefined while the page is live
  #end = 0;
  #time = 0;
  #isPlaying = false;
  #lastFrame; // milliseconds
  #lastShown = 0; // milliseconds

  /**
   * @param liveTime answers the time of the newest snapshot
   * @param floorName answers the name of the floor that is shown
   * @param onChange called when another time is shown, or data have been loaded
   */
  constructor(liveTime, floorName, onChange) {
    this.#liveTime = liveTime;
    this.#floorName = floorName;
    this.#onChange = onChange;
    $('#replay-open').addEventListener('click', () => this.#open());
    $('#replay-live').addEventListener('click', () => this.#close());
    $('#replay-play').addEventListener('click', () => this.#setPlaying(!this.#isPlaying));
    $('#replay-back').addEventListener('click', () => this.#seek(this.#time - STEP));
    $('#replay-forward').addEventListener('click', () => this.#seek(this.#time + STEP));
    $('#replay-time').addEventListener('input', (event) => this.#seek(event.target.valueAsNumber));
    $('#replay-hours').addEventListener('change', () => this.#setRange());
  }

  get isOpen() {
    return this.#data !== undefined;
  }

  /** The time shown. */
  get time() {
    return this.#time;
  }

  /** Whether the data of the time shown are still being fetched. */
  get isLoading() {
    return !this.#data.isLoaded(this.#time);
  }

  poseOf(robot) {
    return this.#data.poseOf(robot, this.#time);
  }

  /** The names of robots that have a track at the time shown. */
  get robots() {
    return this.#data.robots(this.#time);
  }

  /** The loads at the time shown: each with its task, where it was, or the robots that carried it. */
  get loads() {
    return this.#data.loads(this.#time);
  }

  /** The points that a robot had ahead at the time shown. */
  pathOf(robot) {
    return this.#data.pathOf(robot, this.#time);
  }

  /** The latest events before the time shown, newest first. */
  get events() {
    return this.#data.events(this.#time);
  }

  /** To be called when another floor is shown. */
  changeFloor() {
    if (this.isOpen) {
      this.#data = new ReplayData(this.#floorName(), this.#end, this.#onChange);
      this.#show();
    }
  }

  /**
   * Advances to the time that a frame shows.
   *
   * @param now of the frame, milliseconds
   * @returns whether the next frame shows another time
   */
  advance(now) {
    const elapsed = now - (this.#lastFrame ?? now);
    this.#lastFrame = now;
    if (this.#isPlaying && !this.isLoading) {
      this.#time = Math.min(this.#end, this.#time + elapsed * Number($('#replay-speed').value));
      this.#setPlaying(this.#time < this.#end);
      this.#showAtIntervals(now);
    }
    return this.#isPlaying;
  }

  /** The lists need not follow each frame. */
  #showAtIntervals(now) {
    if (!this.#isPlaying || now - this.#lastShown >= LIST_INTERVAL) {
      this.#lastShown = now;
      this.#show();
    }
  }

  #open() {
    this.#end = this.#liveTime() - STORAGE_DELAY;
    this.#data = new ReplayData(this.#floorName(), this.#end, this.#onChange);
    this.#time = this.#end;
    $('#replay-time').max = this.#end;
    this.#setRange();
    this.#showControls();
    $('#replay-time').focus();
  }

  #close() {
    this.#setPlaying(false);
    this.#data = undefined;
    this.#showControls();
    $('#replay-open').focus();
    this.#onChange();
  }

  #showControls() {
    $('#replay').hidden = !this.isOpen;
    $('#replay-open').hidden = this.isOpen;
    $('#replay-banner').hidden = !this.isOpen;
    $('#replay-failed').hidden = true;
  }

  #setRange() {
    const slider = $('#replay-time');
    slider.min = this.#end - Number($('#replay-hours').value) * HOUR;
    slider.step = STEP;
    this.#seek(this.#time);
  }

  #seek(time) {
    this.#time = Math.min(this.#end, Math.max(Number($('#replay-time').min), time));
    this.#show();
  }

  #setPlaying(isPlaying) {
    if (isPlaying === this.#isPlaying) {
      return;
    }
    this.#isPlaying = isPlaying;
    this.#lastFrame = undefined;
    setText($('#replay-play'), text(isPlaying ? 'replay.pause' : 'replay.play'));
    this.#show();
  }

  #show() {
    if (!this.isOpen) {
      return;
    }
    const slider = $('#replay-time');
    slider.valueAsNumber = this.#time;
    const moment = format.format(this.#time);
    setText($('#replay-moment'), moment);
    if (!this.#isPlaying || document.activeElement !== slider) {
      slider.ariaValueText = moment; // a screen reader would read each of them aloud while it plays
    }
    $('#replay-play').disabled = this.#time >= this.#end;
    this.#load();
    this.#onChange();
  }

  async #load() {
    const data = this.#data;
    let failed = false;
    try {
      await data.load(this.#time);
    } catch {
      failed = true;
    }
    if (data === this.#data) {
      $('#replay-failed').hidden = !failed;
      this.#setPlaying(this.#isPlaying && !failed);
    }
  }
}
