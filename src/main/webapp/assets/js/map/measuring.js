import {drawPath, drawPoint} from '../floor/points.js';
import {setText} from '../shared/elements.js';
import {roundedMetres} from '../shared/locale.js';
import {address} from '../shared/server.js';
import {text} from '../shared/texts.js';

const PROMPTS = ['map.measure.start', 'map.measure.goal', 'map.measure.asking']; // by the ends that there are

/** Asks how far it is between two points of the map that are clicked, and shows the path. */
export class Measuring {
  #bar;
  #button;
  #canvas;
  #ends = []; // none, the start, or start and goal
  #path = [];
  #requests = 0;

  /**
   * @param bar says what is to be clicked and what was found, and has the button that ends it
   * @param button begins it, and ends it
   */
  constructor(bar, button, canvas) {
    this.#bar = bar;
    this.#button = button;
    this.#canvas = canvas;
    button.addEventListener('click', () => (this.isOpen ? this.close() : this.#open()));
    bar.querySelector('button').addEventListener('click', () => this.close());
    addEventListener('keydown', ({key}) => {
      if (key === 'Escape' && this.isOpen) {
        this.close();
      }
    });
  }

  get isOpen() {
    return !this.#bar.hidden;
  }

  #open() {
    this.#canvas.viewport.stopFollowing();
    this.#show(true);
    this.#restart([]);
  }

  close() {
    this.#show(false);
    this.#restart([]);
  }

  #show(isOpen) {
    this.#bar.hidden = !isOpen;
    this.#button.setAttribute('aria-pressed', String(isOpen));
  }

  /** Takes a clicked point, or the station that it is on; after a goal it is a new start. */
  async pick(x, y, metresPerPixel, floor) {
    const point = floor.stationAt(x, y, metresPerPixel) ?? {x, y};
    if (this.#ends.length !== 1) {
      this.#restart([point]);
      return;
    }
    this.#restart([...this.#ends, point]);
    const request = this.#requests;
    const {sentence, path} = await ask(floor.name, this.#ends);
    if (request === this.#requests) {
      this.#path = path;
      this.#say(sentence);
      this.#canvas.requestFrame();
    }
  }

  #restart(ends) {
    this.#requests++;
    this.#ends = ends;
    this.#path = [];
    this.#say(text(PROMPTS[ends.length]));
    this.#canvas.requestFrame();
  }

  #say(sentence) {
    setText(this.#bar.querySelector('bdi'), sentence);
  }

  draw(context, viewport, colours) {
    drawPath(context, viewport, colours, this.#path);
    this.#ends.forEach((end, i) => drawPoint(context, viewport, colours, i === 0, end));
  }
}

async function ask(floor, [start, goal]) {
  const query = new URLSearchParams({floor, start: place(start), goal: place(goal)});
  try {
    const answer = await fetch(address(`api/v1/path?${query}`), {headers: {accept: 'application/json'}});
    const body = await answer.json();
    if (!answer.ok) {
      return {sentence: body.detail, path: []};
    }
    return body.points.length > 0
      ? {sentence: text('map.measure.metres', roundedMetres(body.metres)), path: body.points}
      : {sentence: text('map.measure.cells'), path: []};
  } catch {
    return {sentence: text('map.measure.failed'), path: []};
  }
}

/** As the API takes it. */
function place({name, x, y}) {
  return name ?? `${x.toFixed(3)},${y.toFixed(3)}`;
}
