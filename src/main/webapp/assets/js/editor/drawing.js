import {rowsOf} from '../floor/runs.js';

export const PLACE_KINDS = ['stations', 'parking', 'charging'];
export const AREA_KINDS = ['keepOut', 'speedLimits', 'oneWay', 'freeZones'];
export const KINDS = [...PLACE_KINDS, ...AREA_KINDS];

/** What is drawn of a floor: a grid of cells, which of them are walls, and the things over them, by kind. */
export class Drawing {
  grid; // {width, height, resolution, origin}: cells, metres
  walls; // 1 where a cell is wall, row by row from the top
  things; // a list for each of KINDS; never changed, only replaced
  moves; // by which robots drive alone: heading or smooth

  /** @param json as the API gives a drawing */
  constructor(json) {
    const {width, height, resolution, origin, occupied = [], moves = 'heading'} = json;
    this.grid = {width, height, resolution, origin};
    this.walls = new Uint8Array(width * height);
    for (const {column, row, count} of rowsOf(occupied, width)) {
      this.walls.fill(1, row * width + column, row * width + column + count);
    }
    this.moves = moves;
    this.things = Object.fromEntries(KINDS.map((kind) => [kind, json[kind] ?? []]));
  }

  /** As the API takes it. */
  toJson() {
    const {walls} = this;
    const occupied = [];
    for (let from = walls.indexOf(1); from >= 0;) {
      const end = walls.indexOf(0, from);
      const to = end < 0 ? walls.length : end;
      occupied.push(from, to - from);
      from = walls.indexOf(1, to);
    }
    return {...this.grid, occupied, ...this.things, moves: this.moves};
  }

  /** Metres. */
  get bounds() {
    const {width, height, resolution, origin} = this.grid;
    return {x: origin.x, y: origin.y, width: width * resolution, height: height * resolution};
  }

  contains({column, row}) {
    return column >= 0 && row >= 0 && column < this.grid.width && row < this.grid.height;
  }

  indexOf({column, row}) {
    return row * this.grid.width + column;
  }

  isWall(cell) {
    return this.contains(cell) && this.walls[this.indexOf(cell)] === 1;
  }

  /** The cell of a map point; it may lie outside the grid. */
  cellAt(x, y) {
    const {height, resolution, origin} = this.grid;
    return {
      column: Math.floor((x - origin.x) / resolution),
      row: height - 1 - Math.floor((y - origin.y) / resolution),
    };
  }

  /** The middle of a cell, metres. */
  centre({column, row}) {
    const {height, resolution, origin} = this.grid;
    return {
      x: rounded(origin.x + (column + 0.5) * resolution),
      y: rounded(origin.y + (height - row - 0.5) * resolution),
    };
  }

  /** The area of a rectangle of cells, metres. */
  area({left, right, top, bottom}) {
    const {height, resolution, origin} = this.grid;
    return {
      x: rounded(origin.x + left * resolution),
      y: rounded(origin.y + (height - 1 - bottom) * resolution),
      width: rounded((right - left + 1) * resolution),
      height: rounded((bottom - top + 1) * resolution),
    };
  }

  /** Every thing with where it is kept: {kind, index, thing}. */
  *all() {
    for (const kind of KINDS) {
      for (const [index, thing] of this.things[kind].entries()) {
        yield {kind, index, thing};
      }
    }
  }

  /**
   * The drawing with so many more cells on each side, or fewer, as the API gives it.
   *
   * @param more cells at the left, right, top and bottom
   */
  resized({left, right, top, bottom}) {
    const {width, height, resolution, origin} = this.grid;
    const wider = new Drawing({
      width: width + left + right,
      height: height + top + bottom,
      resolution,
      origin: {x: rounded(origin.x - left * resolution), y: rounded(origin.y - bottom * resolution)},
    });
    for (let row = 0; row < height; row++) {
      for (let column = 0; column < width; column++) {
        const moved = {column: column + left, row: row + top};
        if (this.walls[row * width + column] && wider.contains(moved)) {
          wider.walls[wider.indexOf(moved)] = 1;
        }
      }
    }
    return {...wider.toJson(), ...this.things, moves: this.moves};
  }
}

export function isPlace(kind) {
  return PLACE_KINDS.includes(kind);
}

/** To a micrometre. */
export function rounded(metres) {
  return Math.round(metres * 1e6) / 1e6;
}
