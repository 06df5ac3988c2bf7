import {FloorCanvas} from '../floor/floor-canvas.js';
import {Floor} from '../floor/floor.js';
import {drawLabel} from '../floor/labels.js';
import {drawPath, drawPoint} from '../floor/points.js';
import {numberIn} from '../shared/locale.js';
import {text} from '../shared/texts.js';
import '../shared/time-zone.js';
import {PlaceFields} from './place-fields.js';
import {TaskPreview} from './task-preview.js';

// A form that is filled in UTC is read in the reader's own time zone.
const filled = document.querySelector('#deadline[data-in-utc]');
if (filled?.value) {
  const moment = new Date(`${filled.value}Z`);
  filled.value = new Date(moment - 60000 * moment.getTimezoneOffset()).toISOString().slice(0, 16);
}

const $ = (selector) => document.querySelector(selector);

/** The fields of a task's start or goal, which may be a charger. */
class StopFields extends PlaceFields {
  /** @param name start or goal */
  constructor(name) {
    super(name, $(`#${name}Station`), $(`#${name}X`), $(`#${name}Y`));
    this.choice = $(`input[name="picks"][value="${name}"]`);
  }

  get value() {
    return this.station.value ? stopAt(this.station.value) : super.value;
  }

  pointOn(floor) {
    const {charge} = this.value ?? {};
    return charge ? floor.charging.find(({name}) => name === charge.charger) : super.pointOn(floor);
  }
}

/** The form of a new task, with a map on which start and goal are set and the preview is shown. */
class NewTaskPage {
  #floor; // undefined until it is loaded
  #path = []; // of the load
  #start = new StopFields('start');
  #goal = new StopFields('goal');
  #canvas = new FloorCanvas($('#map'), this.#draw.bind(this), this.#pick.bind(this));
  #preview = new TaskPreview($('form.task'), $('#preview'), () => this.#order, (path) => this.#showPath(path));

  async start() {
    $('#kind')?.addEventListener('change', () => this.#showKind());
    this.#showKind();
    for (const place of this.#places) {
      place.onChange(() => this.#changePlaces());
    }
    $('select#floor')?.addEventListener('change', (event) => {
      const page = new URL(location.href);
      page.searchParams.set('floor', event.target.value);
      location.assign(page);
    });
    await this.#showFloor($('#map').dataset.floor);
    this.#preview.request();
  }

  get #isDrive() {
    return $('#kind')?.value === 'drive';
  }

  get #places() {
    return this.#isDrive ? [this.#goal] : [this.#start, this.#goal];
  }

  /** What has no meaning for the other kind of task is neither shown nor sent. */
  #showKind() {
    const kind = this.#isDrive ? 'drive' : 'transport';
    for (const part of document.querySelectorAll('[data-for]')) {
      part.hidden = part.dataset.for !== kind;
      for (const field of [part, ...part.querySelectorAll('input, select')]) {
        field.disabled = part.hidden;
      }
    }
    if (this.#isDrive) {
      this.#goal.choice.checked = true;
    }
    this.#changePlaces();
  }

  #draw(context, viewport, colours) {
    if (!this.#floor) {
      return false;
    }
    this.#floor.draw(context, viewport, colours);
    drawPath(context, viewport, colours, this.#path);
    for (const place of this.#places) {
      const point = place.pointOn(this.#floor);
      if (point) {
        drawPlace(context, viewport, colours, place.name, point);
      }
    }
    return false;
  }

  #pick(x, y, metresPerPixel) {
    const place = this.#places.find(({choice}) => choice.checked) ?? this.#goal;
    const near = this.#floor?.stationAt(x, y, metresPerPixel);
    if (near) {
      place.setStation(near.name);
    } else {
      place.setPoint(x, y);
    }
    if (place === this.#start) {
      this.#goal.choice.checked = true;
    }
    this.#changePlaces();
  }

  /** The path shown is outdated as soon as its ends change. */
  #changePlaces() {
    this.#showPath([]);
    this.#preview.request();
  }

  #showPath(path) {
    this.#path = path;
    this.#canvas.requestFrame();
  }

  /** The form's task as the API takes it; undefined while load, start or goal are missing. */
  get #order() {
    return this.#isDrive ? this.#driveOrder : this.#transportOrder;
  }

  get #driveOrder() {
    const goal = this.#goal.value;
    return goal && {...this.#commonOrder, kind: 'DRIVE', stops: [withWait(goal, values('goalWait')[0]), ...furtherStops()]};
  }

  get #commonOrder() {
    return {
      name: $('#name').value.trim() || '?',
      floor: this.#floor?.name,
      priority: number('priority'),
      onlyRobots: [...document.querySelectorAll('input[name="onlyRobots"]:checked')].map(({value}) => value),
    };
  }

  get #transportOrder() {
    const load = number('load');
    const [start, goal] = this.#places.map(({value}) => value);
    if (load === undefined || !start || !goal) {
      return undefined;
    }
    const [length, width] = [number('length'), number('width')];
    const stops = oneRobotsWay(start, goal);
    return {
      ...this.#commonOrder,
      load,
      ...(stops ? {stops} : {start, goal}),
      size: length && width ? {length, width} : undefined,
    };
  }

  async #showFloor(name) {
    try {
      this.#floor = await Floor.load(name);
      this.#canvas.viewport.setBounds(this.#floor.bounds);
      this.#canvas.requestFrame();
    } catch {
      $('.picker small').textContent = text('map.failed');
    }
  }
}

/** All stops, as the API takes them, where one robot goes the whole way; else undefined. */
function oneRobotsWay(start, goal) {
  const further = furtherStops();
  const way = [withWait(start, values('startWait')[0]), withWait(goal, values('goalWait')[0]), ...further];
  const hasWait = way.some(({waitForPerson, waitSeconds}) => waitForPerson || waitSeconds);
  return hasWait || (further.length > 0 && $('#carriedBy').value === 'one') ? way : undefined;
}

function values(name) {
  return [...document.querySelectorAll(`select[name="${name}"]`)].map(({value}) => value);
}

function furtherStops() {
  const waits = values('stopWait');
  return values('stopStation')
    .map((station, at) => station && withWait(stopAt(station), waits[at]))
    .filter((stop) => stop);
}

/** @param chosen a station, coordinates, or a charger as the form has it: charge, or charge@ and its name */
function stopAt(chosen) {
  const [, x, y] = chosen.match(/^(-?[\d.]+) (-?[\d.]+)$/) ?? [];
  if (x) {
    return {x: Number(x), y: Number(y)};
  }
  const [, charger] = chosen.match(/^charge(?:@(.*))?$/) ?? [];
  return /^charge(@|$)/.test(chosen) ? {charge: {charger}} : {station: chosen};
}

/** @param wait as the form has it: person, a number of seconds, or nothing */
function withWait(place, wait) {
  if (!wait) {
    return place;
  }
  if (wait.endsWith('%')) {
    return {...place, charge: {...place.charge, until: Number.parseInt(wait, 10) / 100}};
  }
  return wait === 'person' ? {...place, waitForPerson: true} : {...place, waitSeconds: Number(wait)};
}

function number(id) {
  return numberIn($(`#${id}`));
}

function drawPlace(context, viewport, colours, name, point) {
  drawPoint(context, viewport, colours, name === 'start', point);
  const [x, y] = viewport.toScreen(point.x, point.y);
  drawLabel(context, colours, text(`newTask.${name}`), x, y - 12, 'bottom');
}

await new NewTaskPage().start();
