import {FloorCanvas} from '../floor/floor-canvas.js';
import {Floor} from '../floor/floor.js';
import {subscribe} from '../shared/event-stream.js';
import {updateLiveRegions} from '../shared/live-regions.js';
import {fetchJson} from '../shared/server.js';

/** Milliseconds between two updates of the track. */
const TRACK_INTERVAL = 30_000;

/** The track of a robot on its floor, up to where it is now. */
class Track {
  #robot;
  #hours;
  #canvas;
  #floor; // undefined until it is loaded
  #points = [];
  #pose; // undefined until it is known

  constructor(element) {
    this.#robot = element.dataset.robot;
    this.#hours = element.dataset.hours;
    this.#canvas = new FloorCanvas(element, this.#draw.bind(this));
  }

  async start(floor) {
    subscribe((snapshot) => this.#update(snapshot));
    this.#floor = await Floor.load(floor);
    this.#canvas.viewport.setBounds(this.#floor.bounds);
    await this.#load();
    setInterval(() => this.#load().catch(() => {}), TRACK_INTERVAL); // a failure is made up for by the next one
  }

  #update(snapshot) {
    updateLiveRegions(snapshot);
    this.#pose = snapshot.robots.find(({name}) => name === this.#robot)?.pose;
    this.#canvas.requestFrame();
  }

  async #load() {
    ({points: this.#points} = await fetchJson(`api/v1/tracks/${encodeURIComponent(this.#robot)}?hours=${this.#hours}`));
    document.querySelector('#track-none').hidden = this.#points.length > 0;
    this.#canvas.requestFrame();
  }

  #draw(context, viewport, colours) {
    if (!this.#floor) {
      return false;
    }
    this.#floor.draw(context, viewport, colours);
    const path = this.#pose ? [...this.#points, this.#pose] : this.#points;
    context.beginPath();
    for (const {x, y} of path) {
      context.lineTo(...viewport.toScreen(x, y));
    }
    context.strokeStyle = colours['state-driving'];
    context.lineWidth = 2;
    context.lineJoin = 'round';
    context.globalAlpha = 0.6;
    context.stroke();
    context.globalAlpha = 1;
    if (this.#pose) {
      context.beginPath();
      context.arc(...viewport.toScreen(this.#pose.x, this.#pose.y), 6, 0, 2 * Math.PI);
      context.fillStyle = colours['state-driving'];
      context.fill();
    }
    return false;
  }
}

const canvas = document.querySelector('#track');
await new Track(canvas).start(canvas.dataset.floor);
