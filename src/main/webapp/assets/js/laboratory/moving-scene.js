import {createElement, setText} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';

const SVG = 'http://www.w3.org/2000/svg';

/** A scene is shown within about so many seconds, however long it took. */
const SHOWN_SECONDS = 12;

const seconds = new Intl.NumberFormat(locale, {maximumFractionDigits: 1});

/** The bodies of an experiment's scene move over its picture, played or by a slider. */
export class MovingScene {
  #motion;
  #circles;
  #slider;
  #button = createElement('button', 'outline');
  #time = createElement('output');
  #last; // index of the last point of the longest track
  #at = 0; // points
  #shownAt; // milliseconds of the page's clock; undefined: it stands

  /**
   * @param element with the picture; it gets what plays the scene
   * @param motion as the API tells it
   */
  constructor(element, motion) {
    this.#motion = motion;
    this.#last = Math.max(1, ...motion.bodies.map(({track}) => track.length - 1));
    this.#circles = this.#draw(element.querySelector('.stage'));
    this.#button.type = 'button';
    this.#button.addEventListener('click', () => (this.#shownAt === undefined ? this.#play() : this.#stop()));
    this.#slider = createElement('input');
    Object.assign(this.#slider, {type: 'range', min: 0, max: this.#last, step: 'any', value: 0});
    this.#slider.setAttribute('aria-labelledby', this.#nameHeading(element));
    this.#slider.addEventListener('input', () => {
      this.#stop();
      this.#show(Number(this.#slider.value));
    });
    element.querySelector('.stage').after(createElement('div', 'player', this.#button, this.#slider, this.#time));
    this.#stop();
    this.#show(0);
  }

  #nameHeading(element) {
    const heading = element.querySelector('h3');
    heading.id ||= `scene-${[...document.querySelectorAll('[data-motion]')].indexOf(element)}`;
    return heading.id;
  }

  #draw(stage) {
    const {picture, bodies} = this.#motion;
    const over = document.createElementNS(SVG, 'svg');
    over.setAttribute('viewBox', `0 0 ${picture.width} ${picture.height}`);
    over.setAttribute('aria-hidden', 'true');
    const circles = bodies.map(({label, radius, colour}) => {
      const circle = document.createElementNS(SVG, 'circle');
      circle.setAttribute('r', Math.max(3, radius * picture.scale));
      circle.setAttribute('fill', colour);
      circle.setAttribute('stroke', 'white');
      const title = document.createElementNS(SVG, 'title');
      title.textContent = label;
      circle.append(title);
      over.append(circle);
      return circle;
    });
    stage.append(over);
    return circles;
  }

  #play() {
    this.#at = this.#at >= this.#last ? 0 : this.#at;
    this.#shownAt = performance.now();
    setText(this.#button, text('laboratory.pause'));
    requestAnimationFrame((now) => this.#advance(now));
  }

  #stop() {
    this.#shownAt = undefined;
    setText(this.#button, text('laboratory.play'));
  }

  #advance(now) {
    if (this.#shownAt === undefined) {
      return;
    }
    const passed = Math.max(0, now - this.#shownAt) / 1_000;
    this.#shownAt = now;
    this.#show(Math.min(this.#last, this.#at + (passed * this.#last) / SHOWN_SECONDS));
    if (this.#at >= this.#last) {
      this.#stop();
    } else {
      requestAnimationFrame((next) => this.#advance(next));
    }
  }

  #show(at) {
    const {picture, least, most, bodies, step} = this.#motion;
    this.#at = at;
    this.#slider.value = at;
    setText(this.#time, text('laboratory.seconds', seconds.format(at * step)));
    bodies.forEach(({track}, i) => {
      const before = Math.min(Math.floor(at), track.length - 1);
      const [x, y] = track[before];
      const [nextX, nextY] = track[Math.min(before + 1, track.length - 1)];
      const share = at - before > 1 ? 1 : at - before;
      this.#circles[i].setAttribute('cx', picture.left + (x + (nextX - x) * share - least[0]) * picture.scale);
      this.#circles[i].setAttribute('cy', picture.top + (most[1] - y - (nextY - y) * share) * picture.scale);
    });
  }
}
