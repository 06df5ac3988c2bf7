import {drawLabel} from '../floor/labels.js';
import {text} from '../shared/texts.js';
import {radius} from './robots.js';

const STEP = 7; // pixels between two lines of a hatch

/**
 * Draws the cells of a floor that are blocked: obstacles crosshatched, cells reserved for lost
 * robots hatched in one direction.
 *
 * @param view the floor's part of the snapshot
 */
export function drawBlockedCells(context, viewport, colours, floor, view) {
  for (const {cells} of view.kept) {
    drawHatched(context, floor.boxes(viewport, cells), colours['state-silent'], [1]);
  }
  drawHatched(context, floor.boxes(viewport, view.obstacles), colours['map-obstacle'], [1, -1]);
}

/**
 * Writes beside each obstacle that robots have seen how long ago one saw it last.
 *
 * @param now milliseconds since 1970, by the server's clock
 */
export function drawAges(context, viewport, colours, floor, seen, now) {
  for (const {cells, last} of seen) {
    const boxes = floor.boxes(viewport, cells);
    const left = Math.min(...boxes.map(([x]) => x));
    const right = Math.max(...boxes.map(([x, , width]) => x + width));
    const bottom = Math.max(...boxes.map(([, y, , height]) => y + height));
    const seconds = Math.max(0, Math.floor((now - Date.parse(last)) / 1000));
    drawLabel(context, colours, text('map.seenAgo', seconds), (left + right) / 2, bottom + 4, 'top');
  }
}

/**
 * Draws a dashed ring and an exclamation mark at each robot that is part of a standstill.
 *
 * @param poseOf answers the pose at which a robot is shown
 */
export function drawStandstills(context, viewport, colours, view, robots, poseOf) {
  const stuck = new Set(view.standstills.flatMap((standstill) => standstill.robots));
  for (const robot of robots.filter(({name}) => stuck.has(name))) {
    const pose = poseOf(robot.name);
    if (pose) {
      drawStandstill(context, viewport, colours, robot, pose);
    }
  }
}

function drawStandstill(context, viewport, colours, robot, pose) {
  const [x, y] = viewport.toScreen(pose.x, pose.y);
  const r = 1.8 * radius(viewport, robot);
  context.strokeStyle = colours['state-error'];
  context.lineWidth = 3;
  context.setLineDash([8, 5]);
  context.beginPath();
  context.arc(x, y, r, 0, 2 * Math.PI);
  context.stroke();
  context.setLineDash([]);
  const [badgeX, badgeY] = [x + 0.75 * r, y + 0.75 * r];
  context.beginPath();
  context.arc(badgeX, badgeY, 9, 0, 2 * Math.PI);
  context.fillStyle = colours['state-error'];
  context.fill();
  context.fillStyle = '#fff';
  context.font = `700 13px ${colours.font}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText('!', badgeX, badgeY + 1);
}

/**
 * @param boxes [x, y, width, height] in pixels
 * @param slopes of the lines: 1 rises to the right, -1 falls
 */
function drawHatched(context, boxes, colour, slopes) {
  context.strokeStyle = colour;
  context.fillStyle = colour;
  for (const [x, y, width, height] of boxes) {
    context.save();
    context.beginPath();
    context.rect(x, y, width, height);
    context.globalAlpha = 0.2;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 1.5;
    context.stroke();
    context.clip();
    context.beginPath();
    for (const slope of slopes) {
      addLines(context, x, y, width, height, slope);
    }
    context.lineWidth = 1.2;
    context.stroke();
    context.restore();
  }
}

/** Lines that continue those of the neighbouring boxes. */
function addLines(context, x, y, width, height, slope) {
  const [top, bottom] = [slope * y, slope * (y + height)];
  const first = Math.floor((x + Math.min(top, bottom)) / STEP) * STEP;
  for (let at = first; at <= x + width + Math.max(top, bottom); at += STEP) {
    context.moveTo(at - top, y);
    context.lineTo(at - bottom, y + height);
  }
}
