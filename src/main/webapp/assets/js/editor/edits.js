import {Drawing} from './drawing.js';

/**
 * Changes a drawing, one step after the other, each of which can be undone and done again. A step is cells that became
 * wall or free, other things, other moves of robots, or another drawing as a whole.
 */
export class Edits {
  drawing;
  #done = [];
  #undone = [];
  #flipped = new Set(); // indices of cells of the stroke that is being drawn
  #onChange;

  /**
   * @param onChange called with the indices of the cells that have changed, or nothing where all may have, and whether
   *     a step is complete
   */
  constructor(json, onChange) {
    this.drawing = new Drawing(json);
    this.#onChange = onChange;
  }

  get canUndo() {
    return this.#done.length > 0;
  }

  get canRedo() {
    return this.#undone.length > 0;
  }

  /** Makes cells walls or free, as a part of the stroke that is being drawn. */
  setWalls(cells, isWall) {
    const changed = [];
    const {drawing} = this;
    for (const cell of cells) {
      if (drawing.contains(cell) && drawing.isWall(cell) !== isWall) {
        const index = drawing.indexOf(cell);
        drawing.walls[index] ^= 1;
        this.#flipped.has(index) ? this.#flipped.delete(index) : this.#flipped.add(index);
        changed.push(index);
      }
    }
    this.#onChange(changed, false);
  }

  /** Ends the stroke; answers how many cells it changed. */
  endStroke() {
    const cells = [...this.#flipped];
    this.#flipped.clear();
    if (cells.length > 0) {
      this.#remember({cells});
      this.#onChange([], true);
    }
    return cells.length;
  }

  cancelStroke() {
    const cells = [...this.#flipped];
    this.#flipped.clear();
    this.#flip(cells);
    this.#onChange(cells, false);
  }

  /** @param things lists of the kinds that are to be other ones */
  setThings(things) {
    this.#set('things', {...this.drawing.things, ...things});
  }

  /** @param moves by which robots drive alone: heading or smooth */
  setMoves(moves) {
    this.#set('moves', moves);
  }

  #set(field, value) {
    const before = this.drawing[field];
    this.drawing[field] = value;
    this.#remember({before: {[field]: before}, after: {[field]: value}});
    this.#onChange([], true);
  }

  /** @param json another drawing */
  replace(json) {
    const before = {...this.drawing};
    const after = {...new Drawing(json)};
    Object.assign(this.drawing, after);
    this.#remember({before, after});
    this.#onChange(undefined, true);
  }

  undo() {
    this.#step(this.#done, this.#undone, 'before');
  }

  redo() {
    this.#step(this.#undone, this.#done, 'after');
  }

  #step(from, to, side) {
    this.cancelStroke();
    const step = from.pop();
    if (!step) {
      return;
    }
    to.push(step);
    if (step.cells) {
      this.#flip(step.cells);
    } else {
      Object.assign(this.drawing, step[side]);
    }
    this.#onChange(step.cells ?? (step.before.walls ? undefined : []), true);
  }

  #flip(cells) {
    for (const index of cells) {
      this.drawing.walls[index] ^= 1;
    }
  }

  #remember(step) {
    this.#done.push(step);
    this.#undone = [];
  }
}
