import {Board} from './board.js';
import {Floor} from './floor.js';
import {showParts} from './parts.js';
import {fetchJson} from './server.js';
import {follow} from './stream.js';

/** Milliseconds from one look at the track to the next. */
const PACE = 30_000;

const canvas = document.querySelector('#track');
const {robot: name, floor: floorName, hours} = canvas.dataset;

let floor;
let points = [];
let place;
const board = new Board(canvas, draw);

function draw(context, viewport, colours) {
  if (!floor) {
    return false;
  }
  floor.draw(context, viewport, colours);
  const way = place ? [...points, place] : points;
  context.beginPath();
  for (const {x, y} of way) {
    context.lineTo(...viewport.toScreen(x, y));
  }
  context.strokeStyle = colours['state-driving'];
  context.lineWidth = 2;
  context.lineJoin = 'round';
  context.globalAlpha = 0.6;
  context.stroke();
  context.globalAlpha = 1;
  if (place) {
    context.beginPath();
    context.arc(...viewport.toScreen(place.x, place.y), 6, 0, 2 * Math.PI);
    context.fillStyle = colours['state-driving'];
    context.fill();
  }
  return false;
}

async function load() {
  ({points} = await fetchJson(`api/v1/tracks/${encodeURIComponent(name)}?hours=${hours}`));
  document.querySelector('#track-none').hidden = points.length > 0;
  board.refresh();
}

follow((snapshot) => {
  showParts(snapshot);
  place = snapshot.robots.find((robot) => robot.name === name)?.pose;
  board.refresh();
});
floor = await Floor.load(floorName);
board.viewport.show(floor.bounds);
await load();
setInterval(() => load().catch(() => {}), PACE); // what cannot be had now comes with the next look
