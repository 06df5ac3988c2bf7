import {FloorCanvas} from '../floor/floor-canvas.js';
import {Floor} from '../floor/floor.js';
import {drawLabel} from '../floor/labels.js';
import {drawPath, drawPoint} from '../floor/points.js';
import {numberIn} from '../shared/locale.js';
import {text} from '../shared/texts.js';
import '../shared/time-zone.js';
import {PlaceFields} from './place-fields.js';
import {TaskPreview} from './task-preview.js';

const form = document.querySelector('form.task');

/** The fields of a place that is asked for. */
function placeFields(fields) {
  const parts = ['station', 'x', 'y'].map((part) => fields.querySelector(`[data-part="${part}"]`));
  return new PlaceFields(fields.dataset.place, ...parts);
}

/** The form of a task from a template, with a map on which places are set and the preview is shown. */
class TemplatePage {
  #floor; // undefined until it is loaded
  #path = [];
  #places = [...form.querySelectorAll('[data-place]')].map(placeFields);
  #canvas = new FloorCanvas(document.querySelector('#map'), this.#draw.bind(this), this.#pick.bind(this));
  #preview = new TaskPreview(form, document.querySelector('#preview'), () => this.#order, (path) => this.#show(path));

  async start() {
    const choice = document.querySelector('.picker fieldset');
    choice.hidden = this.#places.length === 0;
    choice.querySelector('input')?.click();
    for (const place of this.#places) {
      place.onChange(() => this.#change());
    }
    try {
      this.#floor = await Floor.load(document.querySelector('#map').dataset.floor);
      this.#canvas.viewport.setBounds(this.#floor.bounds);
      this.#canvas.requestFrame();
    } catch {
      document.querySelector('#preview').textContent = text('map.failed');
    }
    this.#preview.request();
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
        drawPoint(context, viewport, colours, place === this.#places[0], point);
        const [x, y] = viewport.toScreen(point.x, point.y);
        drawLabel(context, colours, place.name, x, y - 12, 'bottom');
      }
    }
    return false;
  }

  #pick(x, y, metresPerPixel) {
    const choices = [...document.querySelectorAll('input[name="picks"]')];
    const at = choices.findIndex(({checked}) => checked);
    const place = this.#places[at];
    if (place) {
      const near = this.#floor?.stationAt(x, y, metresPerPixel);
      if (near) {
        place.setStation(near.name);
      } else {
        place.setPoint(x, y);
      }
      choices[at + 1]?.click();
      this.#change();
    }
  }

  #change() {
    this.#show([]);
    this.#preview.request();
  }

  #show(path) {
    this.#path = path;
    this.#canvas.requestFrame();
  }

  /** As the API takes it. */
  get #order() {
    return {template: form.dataset.template, values: {...this.#placesEntered, ...this.#othersEntered}};
  }

  get #placesEntered() {
    return Object.fromEntries(this.#places.map(({name, value}) => [name, value]));
  }

  get #othersEntered() {
    const entered = (kind, value) =>
      [...form.querySelectorAll(`[data-${kind}]`)].map((field) => [field.dataset[kind], value(field)]);
    return Object.fromEntries([
      ...entered('number', numberIn),
      ...entered('text', ({value}) => value.trim() || undefined),
      ...entered('moment', ({value}) => value ? new Date(value).toISOString() : undefined),
      ...entered('robots', (field) => {
        const names = [...field.querySelectorAll(':checked')].map(({value}) => value);
        return names.length > 0 ? names : undefined;
      }),
    ]);
  }
}

await new TemplatePage().start();
