import {KINDS, Drawing} from './drawing.js';

const NEARLY = 1e-6; // of a cell

/** What a drawing has that what is in force has not, and the other way round. */
export class Difference {
  added = []; // runs of cells of the drawing that are walls now: {column, row, count}
  removed = []; // runs of cells that were
  things = []; // {kind, change, thing} with change added, removed or changed
  moves; // by which robots drive alone, where that is another than in force
  isOtherGrid = false; // cells of another size or place: they cannot be compared

  /** @param inForce json of the drawing in force */
  constructor(drawing, inForce) {
    const before = new Drawing(inForce);
    this.moves = drawing.moves === before.moves ? undefined : drawing.moves;
    this.#compareThings(drawing.things, before.things);
    this.#compareWalls(drawing, before);
  }

  get isEmpty() {
    return this.added.length + this.removed.length + this.things.length === 0 && !this.moves && !this.isOtherGrid;
  }

  get addedCount() {
    return cellsIn(this.added);
  }

  get removedCount() {
    return cellsIn(this.removed);
  }

  #compareWalls(drawing, before) {
    const {resolution, origin} = drawing.grid;
    const columns = (before.grid.origin.x - origin.x) / resolution;
    const rows = (before.grid.origin.y - origin.y) / resolution;
    const isWhole = (cells) => Math.abs(cells - Math.round(cells)) < NEARLY;
    if (before.grid.resolution !== resolution || !isWhole(columns) || !isWhole(rows)) {
      this.isOtherGrid = true;
      return;
    }
    const right = Math.round(columns);
    const down = drawing.grid.height - before.grid.height - Math.round(rows);
    const last = Math.max(drawing.grid.height, before.grid.height + down);
    for (let row = Math.min(0, down); row < last; row++) {
      this.#compareRow(row, rowOf(drawing, row), rowOf(before, row - down), right);
    }
  }

  /**
   * @param now the walls of a row of the drawing
   * @param then those of what is in force, so many cells further to the right
   */
  #compareRow(row, now, then, right) {
    let run;
    let runs;
    for (let column = Math.min(0, right); column < Math.max(now.length, then.length + right); column++) {
      const is = now[column] === 1;
      const differs = is !== (then[column - right] === 1);
      const wanted = differs ? (is ? this.added : this.removed) : undefined;
      if (wanted && wanted === runs) {
        run.count++;
      } else if (wanted) {
        run = {column, row, count: 1};
        wanted.push(run);
      }
      runs = wanted;
    }
  }

  #compareThings(now, before) {
    for (const kind of KINDS) {
      const keyOf = (thing, index) => thing.name ?? `${index}`;
      const old = new Map(before[kind].map((thing, index) => [keyOf(thing, index), thing]));
      now[kind].forEach((thing, index) => {
        const key = keyOf(thing, index);
        if (!old.has(key)) {
          this.things.push({kind, change: 'added', thing});
        } else if (!isSame(thing, old.get(key))) {
          this.things.push({kind, change: 'changed', thing});
        }
        old.delete(key);
      });
      old.forEach((thing) => this.things.push({kind, change: 'removed', thing}));
    }
  }

  draw(context, viewport, colours, {left, top, cell}) {
    for (const [runs, colour] of [[this.added, 'state-idle'], [this.removed, 'state-error']]) {
      context.fillStyle = colours[colour];
      context.globalAlpha = 0.8;
      for (const {column, row, count} of runs) {
        context.fillRect(left + column * cell, top + row * cell, count * cell, cell);
      }
    }
    context.globalAlpha = 1;
  }
}

const NO_WALLS = new Uint8Array(0);

function rowOf({walls, grid}, row) {
  return row >= 0 && row < grid.height ? walls.subarray(row * grid.width, (row + 1) * grid.width) : NO_WALLS;
}

function cellsIn(runs) {
  return runs.reduce((sum, {count}) => sum + count, 0);
}

function isSame(one, other) {
  const keys = new Set([...Object.keys(one), ...Object.keys(other)]);
  return [...keys].every((key) => (one[key] ?? null) === (other[key] ?? null));
}
