import {Board} from './board.js';
import {Floor} from './floor.js';
import {drawLabel} from './labels.js';
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
const board = new Board($('#map'), draw, pick);

function draw(context, viewport, colours) {
  if (!floor) {
    return false;
  }
  floor.draw(context, viewport, colours);
  const [start, goal] = ends.map(placeOf);
  if (start && goal) {
    context.strokeStyle = colours['map-goal'];
    context.lineWidth = 2;
    context.setLineDash([4, 6]);
    context.beginPath();
    context.moveTo(...viewport.toScreen(start.x, start.y));
    context.lineTo(...viewport.toScreen(goal.x, goal.y));
    context.stroke();
    context.setLineDash([]);
  }
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
  const place = {x: Number.parseFloat(x.value), y: Number.parseFloat(y.value)};
  return Number.isFinite(place.x) && Number.isFinite(place.y) ? place : undefined;
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
  board.refresh();
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
    board.refresh();
  });
  for (const coordinate of [x, y]) {
    coordinate.addEventListener('input', () => {
      station.value = '';
      board.refresh();
    });
  }
}

$('select#floor')?.addEventListener('change', (event) => {
  const here = new URL(location.href);
  here.searchParams.set('floor', event.target.value);
  location.assign(here);
});
await showFloor($('#map').dataset.floor);
