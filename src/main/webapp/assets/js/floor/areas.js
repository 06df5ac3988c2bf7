import {drawLabel} from './labels.js';
import {text} from '../shared/texts.js';

/** Colour and filling of each kind of area. */
export const AREA_COLOURS = {
  keepOut: 'state-error',
  speedLimits: 'map-goal',
  oneWay: 'state-driving',
  freeZones: 'state-idle',
};

export const TURNS = {east: 0, north: -Math.PI / 2, west: Math.PI, south: Math.PI / 2};
const DASHES = {speedLimits: [6, 4], freeZones: [2, 4]};
const ARROW = 26; // pixels between two arrows of a one-way area

/** Keep-out, slow, one-way and free areas, as the API gives them. */
export function drawAreas(context, viewport, colours, areas) {
  for (const [kind, name] of Object.entries(AREA_COLOURS)) {
    const colour = colours[name];
    for (const area of areas[kind] ?? []) { // an older map has none of some kinds
      const box = boxOnScreen(viewport, area);
      drawArea(context, box, kind, colour);
      if (kind === 'oneWay') {
        drawArrows(context, box, area.direction, colour);
      } else if (kind === 'speedLimits' && box.width > 40 && box.height > 16) {
        const words = text('map.speedLimit', String(area.speed));
        drawLabel(context, colours, words, box.x + box.width / 2, box.y + box.height / 2, 'middle', colour);
      }
    }
  }
}

export function boxOnScreen(viewport, {x, y, width, height}) {
  const [left, top] = viewport.toScreen(x, y + height);
  return {x: left, y: top, width: width * viewport.scale, height: height * viewport.scale};
}

function drawArea(context, {x, y, width, height}, kind, colour) {
  context.save();
  context.beginPath();
  context.rect(x, y, width, height);
  context.globalAlpha = 0.16;
  context.fillStyle = colour;
  context.fill();
  context.globalAlpha = 0.9;
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  context.setLineDash(DASHES[kind] ?? []);
  context.stroke();
  if (kind === 'keepOut') {
    context.clip();
    context.globalAlpha = 0.5;
    context.setLineDash([]);
    context.beginPath();
    for (let offset = -height; offset < width; offset += 9) {
      context.moveTo(x + offset, y + height);
      context.lineTo(x + offset + height, y);
    }
    context.stroke();
  }
  context.restore();
}

function drawArrows(context, {x, y, width, height}, direction, colour) {
  const columns = Math.max(1, Math.floor(width / ARROW));
  const rows = Math.max(1, Math.floor(height / ARROW));
  if (columns * rows > 2000) {
    return;
  }
  const size = Math.min(9, width / 2, height / 2);
  for (let column = 0; column < columns; column++) {
    for (let row = 0; row < rows; row++) {
      drawArrow(context, x + (column + 0.5) * width / columns, y + (row + 0.5) * height / rows, TURNS[direction], size, colour);
    }
  }
}

/** Round its middle. */
export function drawArrow(context, x, y, angle, size, colour) {
  context.save();
  context.translate(x, y);
  context.rotate(angle);
  context.beginPath();
  context.moveTo(-size, 0);
  context.lineTo(size, 0);
  context.moveTo(size * 0.4, -size * 0.5);
  context.lineTo(size, 0);
  context.lineTo(size * 0.4, size * 0.5);
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.stroke();
  context.restore();
}
