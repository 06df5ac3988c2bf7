import {Board} from './board.js';
import {Floor} from './floor.js';
import {drawLabel} from './labels.js';
import {numberIn} from './locale.js';
import {Preview} from './preview.js';
import {text} from './texts.js';
import './zone.js';

const SNAP = 14; // pixels around a station that choose it
const $ = (selector) => document.querySelector(selector);

const ends = ['start', 'goal'].map((name) => ({
  name,
  station: $(`#${name}Station`),
  x: $(`#${name}X`),
  y: $(`#${name}Y`),
  choice: $(`input[name="picks"][value="${name}"]`),
}));

let floor;
let way = [];
const board = new Board($('#map'), draw, pick);
const preview = new Preview($('form.task'), $('#preview'), order, (found) => {
  way = found;
  board.refresh();
});

function draw(context, viewport, colours) {
  if (!floor) {
    return false;
  }
  floor.draw(context, viewport, colours);
  context.strokeStyle = colours['map-goal'];
  context.lineWidth = 2.5;
  context.lineJoin = 'round';
  context.setLineDash([7, 5]);
  context.beginPath();
  way.forEach(({x, y}) => context.lineTo(...viewport.toScreen(x, y)));
  context.stroke();
  context.setLineDash([]);
  ends.forEach((end) => drawEnd(context, viewport, colours, end));
  return false;
}

function drawEnd(context, viewport, colours, end) {
  const place = placeOf(end);
  if (!place) {
    return;
  }
  const [x, y] = viewport.toScreen(place.x, place.y);
  context.beginPath();
  if (end.name === 'start') {
    context.roundRect(x - 8, y - 8, 16, 16, 3);
    context.fillStyle = colours['map-load'];
    context.strokeStyle = colours['map-load-line'];
    context.fill();
  } else {
    context.arc(x, y, 9, 0, 2 * Math.PI);
    context.strokeStyle = colours['map-goal'];
  }
  context.lineWidth = 2.5;
  context.stroke();
  drawLabel(context, colours, text(`newTask.${end.name}`), x, y - 12, 'bottom');
}

/** Where the form's fields put the end, if they do. */
function placeOf({station, x, y}) {
  if (station.value) {
    return floor.stations.find(({name}) => name === station.value);
  }
  return where({station, x, y});
}

function pick(x, y, metresPerPixel) {
  const end = ends.find(({choice}) => choice.checked);
  const near = floor?.stations.find(
    (station) => Math.hypot(station.x - x, station.y - y) <= SNAP * metresPerPixel);
  end.station.value = near?.name ?? '';
  end.x.value = near ? '' : x.toFixed(2);
  end.y.value = near ? '' : y.toFixed(2);
  if (end.name === 'start') {
    ends[1].choice.checked = true;
  }
  placesChanged();
}

/** A way is worth nothing once its ends have moved. */
function placesChanged() {
  way = [];
  preview.changed();
  board.refresh();
}

/** What the form asks for; nothing while load, start or goal are missing. */
function order() {
  const load = number('load');
  const [start, goal] = ends.map(where);
  if (load === undefined || !start || !goal) {
    return undefined;
  }
  const [length, width] = [number('length'), number('width')];
  return {
    name: $('#name').value.trim() || '?',
    load, start, goal,
    floor: floor?.name,
    priority: number('priority'),
    size: length && width ? {length, width} : undefined,
  };
}

function where({station, x, y}) {
  if (station.value) {
    return {station: station.value};
  }
  const place = {x: numberIn(x), y: numberIn(y)};
  return place.x === undefined || place.y === undefined ? undefined : place;
}

function number(id) {
  return numberIn($(`#${id}`));
}

async function showFloor(name) {
  try {
    floor = await Floor.load(name);
    board.viewport.show(floor.bounds);
    board.refresh();
  } catch {
    $('.picker small').textContent = text('map.failed');
  }
}

for (const {station, x, y} of ends) {
  station.addEventListener('change', () => {
    if (station.value) {
      x.value = '';
      y.value = '';
    }
    placesChanged();
  });
  for (const coordinate of [x, y]) {
    coordinate.addEventListener('input', () => {
      station.value = '';
      placesChanged();
    });
  }
}

$('select#floor')?.addEventListener('change', (event) => {
  const here = new URL(location.href);
  here.searchParams.set('floor', event.target.value);
  location.assign(here);
});
await showFloor($('#map').dataset.floor);
preview.changed();
