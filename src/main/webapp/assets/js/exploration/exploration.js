import '../shared/live.js';
import {FloorCanvas} from '../floor/floor-canvas.js';
import {rowsOf} from '../floor/runs.js';
import {setText} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {fetchJson} from '../shared/server.js';
import {text} from '../shared/texts.js';

/** Milliseconds between two looks at an exploration that goes on. */
const INTERVAL = 400;

/** Metres, of each robot. */
const ROBOT_RADIUS = 0.25;

const number = new Intl.NumberFormat(locale, {maximumFractionDigits: 1});

/** What a swarm sees of ground that it has no map of, and where it is. */
class Exploration {
  #element;
  #canvas;
  #latest; // as the API tells it; undefined until it is loaded
  #picture; // of what was seen, a pixel a cell

  constructor(element) {
    this.#element = element;
    this.#canvas = new FloorCanvas(element.querySelector('canvas'), this.#draw.bind(this));
  }

  async watch() {
    const {floor, explorationState} = this.#element.dataset;
    try {
      const latest = await fetchJson(`api/v1/floors/${floor}/exploration`);
      if (latest.state !== explorationState) {
        location.reload();
        return;
      }
      this.#show(latest);
    } catch {
      // a failure is made up for by the next look
    }
    if (explorationState === 'RUNNING' || !this.#latest) {
      setTimeout(() => this.watch(), INTERVAL);
    }
  }

  #show(latest) {
    const {width, height, resolution, origin} = latest.seen;
    if (!this.#latest) {
      this.#canvas.viewport.setBounds({...origin, width: width * resolution, height: height * resolution});
    }
    this.#latest = latest;
    this.#picture = undefined;
    const facts = {
      seconds: text('laboratory.seconds', number.format(latest.seconds)),
      driven: text('exploration.metres', number.format(latest.driven)),
      area: text('exploration.squareMetres', number.format(latest.area)),
    };
    for (const [fact, content] of Object.entries(facts)) {
      setText(this.#element.querySelector(`[data-fact=${fact}]`), content);
    }
    const bar = this.#element.querySelector('progress');
    if (bar) {
      bar.value = latest.share;
    }
    this.#canvas.requestFrame();
  }

  #draw(context, viewport, colours) {
    if (!this.#latest) {
      return;
    }
    const {seen, track, positions, start, target} = this.#latest;
    const [left, top] = viewport.toScreen(seen.origin.x, seen.origin.y + seen.height * seen.resolution);
    const cell = seen.resolution * viewport.scale;
    context.imageSmoothingEnabled = false;
    context.drawImage(this.#seen(colours), left, top, seen.width * cell, seen.height * cell);
    context.strokeStyle = colours['state-driving'];
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(...viewport.toScreen(start.x, start.y));
    track.forEach(({x, y}) => context.lineTo(...viewport.toScreen(x, y)));
    context.stroke();
    const [x, y] = viewport.toScreen(target.x, target.y);
    context.strokeStyle = colours['map-goal'];
    context.lineWidth = 3;
    context.beginPath();
    context.arc(x, y, Math.max(5, 0.3 * viewport.scale), 0, 2 * Math.PI);
    context.stroke();
    for (const robot of positions) {
      context.fillStyle = colours[robot.lidar ? 'state-driving' : 'state-idle'];
      context.beginPath();
      context.arc(...viewport.toScreen(robot.x, robot.y), Math.max(3, ROBOT_RADIUS * viewport.scale), 0, 2 * Math.PI);
      context.fill();
    }
  }

  #seen(colours) {
    if (!this.#picture || this.#picture.wall !== colours['map-wall']) {
      const {width, height, free, occupied} = this.#latest.seen;
      const canvas = new OffscreenCanvas(width, height);
      const context = canvas.getContext('2d');
      for (const [runs, colour] of [[free, colours['map-free']], [occupied, colours['map-wall']]]) {
        context.fillStyle = colour;
        for (const {column, row, count} of rowsOf(runs, width)) {
          context.fillRect(column, row, count, 1);
        }
      }
      this.#picture = {canvas, wall: colours['map-wall']};
    }
    return this.#picture.canvas;
  }
}

const element = document.querySelector('#exploration');
if (element) {
  await new Exploration(element).watch();
}
