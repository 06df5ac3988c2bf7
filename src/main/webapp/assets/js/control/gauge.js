import {setText} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';

const RADIUS = 90; // of the scale, in the picture's units
const number = new Intl.NumberFormat(locale, {minimumFractionDigits: 2, maximumFractionDigits: 2, signDisplay: 'negative'});

/** A meter that shows a number from -most to most: the needle upright is 0. */
export class Gauge {
  #needle;
  #value;
  #caption;
  #output;

  constructor(figure) {
    this.#needle = figure.querySelector('.needle');
    this.#value = figure.querySelector('.value');
    this.#caption = figure.querySelector('.caption');
    this.#output = figure.querySelector('output bdi');
  }

  /**
   * @param value undefined: not known
   * @param unit the key of a text with a place for the number
   */
  show(caption, value, most, unit) {
    setText(this.#caption, caption);
    setText(this.#output, value === undefined ? '–' : text(unit, number.format(value)));
    const share = Math.min(1, Math.max(-1, (value ?? 0) / most));
    const angle = (share * Math.PI) / 2;
    this.#needle.setAttribute('transform', `rotate(${(angle * 180) / Math.PI})`);
    const end = `${(RADIUS * Math.sin(angle)).toFixed(1)},${(-RADIUS * Math.cos(angle)).toFixed(1)}`;
    this.#value.setAttribute('d', `M0,${-RADIUS} A${RADIUS},${RADIUS} 0 0 ${share < 0 ? 0 : 1} ${end}`);
  }
}
