import {KINDS, Drawing} from './drawing.js';

const NEARLY = 1e-6; // of a cell

/** What a drawing has that what is in force has not, and the other way round. */
export class Difference {
  added = []; // cells of the drawing that are walls now
  removed = []; // cells that were
  things = []; // {kind, change, thing} with change added, removed or changed
  isOtherGrid = false; // cells of another size or place: they cannot be compared

  /** @param inForce json of the drawing in force */
  constructor(drawing, inForce) {
    const before = new Drawing(inForce);
    this.#compareThings(drawing.things, before.things);
    this.#compareWalls(drawing, before);
  }

  get isEmpty() {
    return this.added.length + this.removed.length + this.things.length === 0 && !this.isOtherGrid;
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
    this.isOtherGrid = false;
    for (let row = Math.min(0, down); row < Math.max(drawing.grid.height, before.grid.height + down); row++) {
      for (let column = Math.min(0, right); column < Math.max(drawing.grid.width, before.grid.width + right); column++) {
        const is = drawing.isWall({column, row});
        if (is !== before.isWall({column: column - right, row: row - down})) {
          (is ? this.added : this.removed).push({column, row});
        }
      }
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
    for (const [cells, colour] of [[this.added, 'state-idle'], [this.removed, 'state-error']]) {
      context.fillStyle = colours[colour];
      context.globalAlpha = 0.8;
      for (const {column, row} of cells) {
        context.fillRect(left + column * cell, top + row * cell, cell, cell);
      }
    }
    context.globalAlpha = 1;
  }
}

function isSame(one, other) {
  const keys = new Set([...Object.keys(one), ...Object.keys(other)]);
  return [...keys].every((key) => (one[key] ?? null) === (other[key] ?? null));
}
