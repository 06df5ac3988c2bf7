import {fetchJson} from '../shared/server.js';
import {drawAreas} from './areas.js';
import {drawGridLines} from './grid-lines.js';
import {drawPlaces} from './places.js';
import {rowsOf} from './runs.js';

const SNAP = 14; // pixels around a station that select it

/** A floor as the API gives it, and how it is drawn. */
export class Floor {
  #map;
  #walls;
  #wallColour = '';
  #outline;
  #picture; // of the floor as it was drawn last
  #pictured = ''; // what the picture shows
  #drawn = ''; // what was drawn last

  constructor(map) {
    this.#map = map;
  }

  /**
   * @param name undefined: the first one
   * @param at milliseconds since 1970; undefined: as it is
   */
  static async load(name, at) {
    const query = new URLSearchParams();
    if (name) {
      query.set('floor', name);
    }
    if (at !== undefined) {
      query.set('at', new Date(at).toISOString());
    }
    return new Floor(await fetchJson(`api/v1/map?${query}`));
  }

  get name() {
    return this.#map.floor;
  }

  /** Names what is drawn: another map has another one. */
  get version() {
    return this.#map.version;
  }

  get stations() {
    return this.#map.stations;
  }

  get charging() {
    return this.#map.charging;
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

  /**
   * From the second frame on of a viewport that stays as it is, only a picture of it is copied.
   *
   * @param showsMargins whether with what robots keep from walls
   */
  draw(context, viewport, colours, showsMargins = false) {
    const {canvas} = context;
    const now = [
      viewport.x, viewport.y, viewport.scale, canvas.width, canvas.height, devicePixelRatio, showsMargins,
      ...Object.values(colours),
    ].join();
    if (now !== this.#drawn) {
      this.#drawn = now;
      this.#drawAll(context, viewport, colours, showsMargins);
      return;
    }
    if (now !== this.#pictured) {
      this.#pictured = now;
      this.#picture = new OffscreenCanvas(canvas.width, canvas.height);
      const copy = this.#picture.getContext('2d');
      copy.setTransform(context.getTransform());
      this.#drawAll(copy, viewport, colours, showsMargins);
    }
    context.save();
    context.resetTransform();
    context.drawImage(this.#picture, 0, 0);
    context.restore();
  }

  #drawAll(context, viewport, colours, showsMargins) {
    const {width, height, resolution} = this.#map;
    const {x, y} = this.bounds;
    const [left, top] = viewport.toScreen(x, y + height * resolution);
    const cell = resolution * viewport.scale;
    context.fillStyle = colours['map-free'];
    context.fillRect(left, top, width * cell, height * cell);
    if (cell >= 10) {
      drawGridLines(context, viewport, colours, {left, top, cell, width, height});
    }
    if (showsMargins) {
      this.#drawMargins(context, colours, left, top, cell);
    }
    context.imageSmoothingEnabled = false;
    context.drawImage(this.#wallPicture(colours['map-wall']), left, top, width * cell, height * cell);
    drawAreas(context, viewport, colours, this.#map);
    drawPlaces(context, viewport, colours, this.#map, resolution);
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
    for (const {column, row, count} of rowsOf(occupied, width)) {
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
    const {width, height, resolution} = this.#map;
    const {x, y} = this.bounds;
    const [left, top] = viewport.toScreen(x, y + height * resolution);
    const cell = resolution * viewport.scale;
    return [...rowsOf(runs, width)].map(({column, row, count}) => [
      left + column * cell, top + row * cell, count * cell, cell,
    ]);
  }

  /** The occupied cells, one pixel each. */
  #wallPicture(colour) {
    if (this.#wallColour !== colour) {
      const {width, height, occupied} = this.#map;
      this.#walls = new OffscreenCanvas(width, height);
      const context = this.#walls.getContext('2d');
      context.fillStyle = colour;
      for (const {column, row, count} of rowsOf(occupied, width)) {
        context.fillRect(column, row, count, 1);
      }
      this.#wallColour = colour;
    }
    return this.#walls;
  }
}
