import {Labels} from './labels.js';
import {fetchJson} from '../shared/server.js';

const SNAP = 14; // pixels around a station that select it

/** A flash in a square from -1 to 1. */
const BOLT = [[0.15, -0.75], [-0.5, 0.15], [-0.05, 0.15], [-0.15, 0.75], [0.5, -0.15], [0.05, -0.15]];

/** A floor as the API gives it, and how it is drawn. */
export class Floor {
  #map;
  #walls;
  #wallColour = '';
  #outline;

  constructor(map) {
    this.#map = map;
  }

  static async load(name) {
    const query = name ? `?floor=${encodeURIComponent(name)}` : '';
    return new Floor(await fetchJson(`api/v1/map${query}`));
  }

  get name() {
    return this.#map.floor;
  }

  get stations() {
    return this.#map.stations;
  }

  /** The station that a click at a map point selects, if there is one. */
  stationAt(x, y, metresPerPixel) {
    return this.stations.find((station) => Math.hypot(station.x - x, station.y - y) <= SNAP * metresPerPixel);
  }

  /** Metres. */
  get bounds() {
    const {origin, width, height, resolution} = this.#map;
    return {x: origin.x, y: origin.y, width: width * resolution, height: height * resolution};
  }

  /** @param showsMargins whether with what robots keep from walls */
  draw(context, viewport, colours, showsMargins = false) {
    const {width, height, resolution} = this.#map;
    const {x, y} = this.bounds;
    const [left, top] = viewport.toScreen(x, y + height * resolution);
    const cell = resolution * viewport.scale;
    context.fillStyle = colours['map-free'];
    context.fillRect(left, top, width * cell, height * cell);
    if (cell >= 10) {
      this.#drawLines(context, viewport, colours, left, top, cell);
    }
    if (showsMargins) {
      this.#drawMargins(context, colours, left, top, cell);
    }
    context.imageSmoothingEnabled = false;
    context.drawImage(this.#wallPicture(colours['map-wall']), left, top, width * cell, height * cell);
    this.#drawPlaces(context, viewport, colours);
  }

  #drawLines(context, viewport, colours, left, top, cell) {
    const {width, height} = this.#map;
    context.beginPath();
    for (let column = 1; column < width; column++) {
      const x = Math.round(left + column * cell) + 0.5;
      if (x > 0 && x < viewport.width) {
        context.moveTo(x, Math.max(0, top));
        context.lineTo(x, Math.min(viewport.height, top + height * cell));
      }
    }
    for (let row = 1; row < height; row++) {
      const y = Math.round(top + row * cell) + 0.5;
      if (y > 0 && y < viewport.height) {
        context.moveTo(Math.max(0, left), y);
        context.lineTo(Math.min(viewport.width, left + width * cell), y);
      }
    }
    context.strokeStyle = colours['map-line'];
    context.lineWidth = 1;
    context.stroke();
  }

  /** That of robots alone light, that of several that carry together dark. */
  #drawMargins(context, colours, left, top, cell) {
    const {margins, resolution, width, height} = this.#map;
    this.#outline ??= this.#wallOutline();
    context.save();
    context.beginPath();
    context.rect(left, top, width * cell, height * cell);
    context.clip();
    context.translate(left, top);
    context.scale(cell, cell);
    context.lineCap = 'round';
    context.strokeStyle = colours['map-goal'];
    for (const [metres, alpha] of [[margins.robot, 0.35], [margins.formation, 0.8]]) {
      context.globalAlpha = alpha;
      context.lineWidth = 2 * metres / resolution;
      context.stroke(this.#outline);
    }
    context.restore();
  }

  /** Where walls, or the map, end; in cells. */
  #wallOutline() {
    const {width, height, occupied} = this.#map;
    const isWall = new Uint8Array(width * height);
    for (const {column, row, count} of this.#rows(occupied)) {
      isWall.fill(1, row * width + column, row * width + column + count);
    }
    const at = (column, row) =>
      column < 0 || row < 0 || column >= width || row >= height ? 1 : isWall[row * width + column];
    const outline = new Path2D();
    for (let row = 0; row <= height; row++) {
      for (let column = 0; column <= width; column++) {
        if (at(column, row) !== at(column, row - 1)) {
          outline.moveTo(column, row);
          outline.lineTo(column + 1, row);
        }
        if (at(column, row) !== at(column - 1, row)) {
          outline.moveTo(column, row);
          outline.lineTo(column, row + 1);
        }
      }
    }
    return outline;
  }

  /**
   * Where cells are on the canvas.
   *
   * @param runs as the API gives cells: index of the first one, number of cells, and so on by turns
   * @return [x, y, width, height] in pixels of each stretch of cells in a row
   */
  boxes(viewport, runs) {
    const {height, resolution} = this.#map;
    const {x, y} = this.bounds;
    const [left, top] = viewport.toScreen(x, y + height * resolution);
    const cell = resolution * viewport.scale;
    return [...this.#rows(runs)].map(({column, row, count}) => [
      left + column * cell, top + row * cell, count * cell, cell,
    ]);
  }

  /** Runs of cells, cut where a row ends. */
  *#rows(runs) {
    const {width} = this.#map;
    for (let i = 0; i < runs.length; i += 2) {
      let [cell, left] = [runs[i], runs[i + 1]];
      while (left > 0) {
        const column = cell % width;
        const count = Math.min(left, width - column);
        yield {column, row: Math.floor(cell / width), count};
        cell += count;
        left -= count;
      }
    }
  }

  /** The occupied cells, one pixel each. */
  #wallPicture(colour) {
    if (this.#wallColour !== colour) {
      const {width, height, occupied} = this.#map;
      this.#walls = new OffscreenCanvas(width, height);
      const context = this.#walls.getContext('2d');
      context.fillStyle = colour;
      for (const {column, row, count} of this.#rows(occupied)) {
        context.fillRect(column, row, count, 1);
      }
      this.#wallColour = colour;
    }
    return this.#walls;
  }

  #drawPlaces(context, viewport, colours) {
    const {stations, parking, charging, resolution} = this.#map;
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
