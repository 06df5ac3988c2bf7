import {setText} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';

const WIDTH = 400; // of the picture
const HEIGHT = 100;

/** Milliseconds that the chart shows. */
const SPAN = 60_000;

/** A number over the last minute, with 0 in the middle; gaps where there was none. */
export class LiveChart {
  #line;
  #value;
  #range;
  #unit;
  #least;
  #number;
  #points = []; // {at, value}, the newest last; value undefined: there was none

  /**
   * @param name of the chart's elements
   * @param unit the key of a text with a place for the number
   * @param least what the chart shows at least to either side
   */
  constructor(name, unit, least, digits) {
    this.#line = document.querySelector(`#chart-${name} polyline`);
    this.#value = document.querySelector(`#value-${name} bdi`);
    this.#range = document.querySelector(`#range-${name}`);
    this.#unit = unit;
    this.#least = least;
    this.#number = new Intl.NumberFormat(locale, {maximumFractionDigits: digits, minimumFractionDigits: digits});
  }

  add(value, now) {
    this.#points.push({at: now, value});
    while (this.#points[0].at < now - SPAN) {
      this.#points.shift();
    }
    this.#draw(now);
  }

  #draw(now) {
    const known = this.#points.filter(({value}) => value !== undefined);
    const most = Math.max(this.#least, ...known.map(({value}) => Math.abs(value)));
    const place = ({at, value}) =>
      `${(WIDTH * (1 - (now - at) / SPAN)).toFixed(1)},${((HEIGHT / 2) * (1 - value / most)).toFixed(1)}`;
    this.#line.setAttribute('points', known.map(place).join(' '));
    const newest = this.#points.at(-1).value;
    setText(this.#value, newest === undefined ? '–' : text(this.#unit, this.#number.format(newest)));
    setText(this.#range, `± ${text(this.#unit, this.#number.format(most))}`);
  }
}
