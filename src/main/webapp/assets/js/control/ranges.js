import {createElement, setText, updateList} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {fetchJson} from '../shared/server.js';
import {text} from '../shared/texts.js';

/** Milliseconds between two questions for what the robot publishes by MQTT. */
const INTERVAL = 500;

/** Seconds after which a range says nothing about now. */
const OLD = 2;

/** Metres below which something is near. */
const NEAR = 0.3;

const number = new Intl.NumberFormat(locale, {minimumFractionDigits: 2, maximumFractionDigits: 2});

/** What range sensors measure, as bars: those that the robot reports, or that it publishes by MQTT. */
export class Ranges {
  #list = document.querySelector('#ranges');
  #none = document.querySelector('#no-ranges');
  #age = document.querySelector('#ranges-age');
  #robot;
  #published; // undefined: none are
  #reported = [];
  #farthest = 1;

  /** @param hasReadings whether the server takes readings by MQTT */
  constructor(robot, hasReadings) {
    this.#robot = robot;
    if (hasReadings) {
      this.#ask();
    }
  }

  update({ranges, sensorRange}) {
    this.#reported = ranges;
    this.#farthest = sensorRange;
    this.#show();
  }

  async #ask() {
    try {
      if (!document.hidden) {
        const {readings} = await fetchJson(`api/v1/robots/${encodeURIComponent(this.#robot)}/readings`);
        this.#published = readings.find(({name}) => name === 'range');
        this.#show();
      }
    } catch {
      this.#published = undefined; // what is shown would be old
    } finally {
      setTimeout(() => this.#ask(), INTERVAL);
    }
  }

  #show() {
    const isPublished = this.#reported.length === 0 && this.#published !== undefined;
    const values = isPublished ? this.#published.values : this.#reported;
    const farthest = isPublished ? Math.max(1, ...values) : this.#farthest;
    const isOld = isPublished && this.#published.age > OLD;
    this.#none.hidden = values.length > 0;
    this.#age.hidden = !isOld;
    if (isOld) {
      setText(this.#age, text('control.ranges.age', Math.round(this.#published.age)));
    }
    this.#list.classList.toggle('old', isOld);
    const entries = values.map((value, index) => ({index, value}));
    updateList(this.#list, entries, ({index}) => index, createBar, (bar, {index, value}) => {
      setText(bar.querySelector('.name'), text('control.sensor', index + 1));
      setText(bar.querySelector('.number'), text('control.unit.metres', number.format(value)));
      const meter = bar.querySelector('.bar span');
      meter.style.inlineSize = `${Math.min(100, (100 * value) / farthest)}%`;
      bar.classList.toggle('near', value < NEAR);
    });
  }
}

function createBar() {
  return createElement('li', '',
    createElement('span', 'name'),
    createElement('span', 'bar', createElement('span')),
    createElement('bdi', 'number'));
}
