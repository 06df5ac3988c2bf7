import {Labels} from './labels.js';

/** A flash in a square from -1 to 1. */
const BOLT = [[0.15, -0.75], [-0.5, 0.15], [-0.05, 0.15], [-0.15, 0.75], [0.5, -0.15], [0.05, -0.15]];

/** Draws stations, charging points and parking points, where there is room with their names. */
export function drawPlaces(context, viewport, colours, {stations, parking, charging}, resolution) {
  const half = Math.min(16, Math.max(4, 0.42 * resolution * viewport.scale));
  const labels = new Labels(context, colours);
  const kinds = [
    [stations, 'map-place', 'dot'],
    [charging, 'map-charging', 'bolt'],
    [parking, 'map-parking', 'P'],
  ];
  for (const [places, colour, sign] of kinds) {
    const style = {half, sign, colour: colours[colour], font: colours.font};
    for (const place of places) {
      drawPlace(context, viewport, labels, place, style);
    }
  }
}

function drawPlace(context, viewport, labels, place, style) {
  const {half, sign, colour} = style;
  const [x, y] = viewport.toScreen(place.x, place.y);
  context.beginPath();
  context.roundRect(x - half, y - half, 2 * half, 2 * half, half / 2.5);
  context.globalAlpha = 0.15;
  context.fillStyle = colour;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  context.stroke();
  if (half >= 6) {
    drawSign(context, x, y, style);
  }
  if (half >= 6 || sign === 'dot') {
    labels.draw(place.name, x, y, half, colour);
  }
}

function drawSign(context, x, y, {half, sign, font}) {
  if (sign === 'P') {
    context.font = `600 ${1.2 * half}px ${font}`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText('P', x, y + 0.06 * half);
    return;
  }
  context.beginPath();
  if (sign === 'bolt') {
    for (const [px, py] of BOLT) {
      context.lineTo(x + px * half, y + py * half);
    }
    context.closePath();
  } else {
    context.arc(x, y, half / 3, 0, 2 * Math.PI);
  }
  context.fill();
}
