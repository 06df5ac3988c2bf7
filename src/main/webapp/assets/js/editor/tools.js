import {text} from '../shared/texts.js';
import {boxOf, cellsOf, lineOf, outlineOf, widened} from './cells.js';
import {isPlace, rounded} from './drawing.js';

/**
 * What the pointer, or the keyboard's cursor, does on the drawing. A stroke begins at a cell, moves over others and
 * ends at one; by the keyboard, tools that need two cells begin at the first Enter and end at the second.
 *
 * @typedef {object} Tool
 * @property needsTwo whether it needs two cells
 * @property start takes a cell; false: there is nothing to begin with
 * @property move takes a cell
 * @property end takes a cell
 * @property cancel as if it had not begun
 * @property shape what it would draw now: {cells} or {box, kind}, with isErasing
 */

/** Makes every cell that it passes wall or free. */
class Brush {
  needsTwo = false;
  #last;

  constructor(editor, isWall) {
    this.editor = editor;
    this.isWall = isWall;
  }

  start(cell) {
    this.#last = cell;
    this.#paint(cell);
    return true;
  }

  move(cell) {
    this.#paint(cell);
  }

  end(cell) {
    this.#paint(cell);
    sayCells(this.editor, this.isWall);
  }

  cancel() {
    this.editor.edits.cancelStroke();
  }

  #paint(cell) {
    this.editor.edits.setWalls(widened(lineOf(this.#last, cell), this.editor.options.width), this.isWall);
    this.#last = cell;
  }
}

/** Spans something between two cells. */
class Span {
  needsTwo = true;
  anchor;
  last;

  constructor(editor, finish, cells) {
    this.editor = editor;
    this.finish = finish;
    this.cells = cells;
  }

  start(cell) {
    this.anchor = this.last = cell;
    this.editor.redraw();
    return true;
  }

  move(cell) {
    this.last = cell;
    this.editor.redraw();
  }

  end(cell) {
    const {anchor} = this;
    this.cancel();
    this.finish(anchor, cell);
  }

  cancel() {
    this.anchor = this.last = undefined;
    this.editor.redraw();
  }

  get shape() {
    return this.anchor && this.cells(this.anchor, this.last);
  }
}

/** @param shapeOf what it would draw */
function walls(editor, cellsBetween, shapeOf = (a, b) => ({cells: [...cellsBetween(a, b)]})) {
  return new Span(
    editor,
    (a, b) => {
      editor.edits.setWalls(cellsBetween(a, b), true);
      sayCells(editor, true);
    },
    shapeOf,
  );
}

function eraser(editor) {
  return new Span(
    editor,
    (a, b) => {
      editor.edits.setWalls(cellsOf(boxOf(a, b)), false);
      sayCells(editor, false);
    },
    (a, b) => ({box: boxOf(a, b), isErasing: true}),
  );
}

function sayCells(editor, isWall) {
  const count = editor.edits.endStroke();
  editor.say(text(isWall ? 'editor.said.walls' : 'editor.said.free', count));
}

/** @param more what such an area has besides its place and size */
function area(editor, kind, more) {
  return new Span(
    editor,
    (a, b) => editor.add(kind, {...editor.drawing.area(boxOf(a, b)), ...more}),
    (a, b) => ({box: boxOf(a, b), kind}),
  );
}

/** Puts a place into a cell. */
class PlaceTool {
  needsTwo = false;

  constructor(editor, kind) {
    this.editor = editor;
    this.kind = kind;
  }

  start(cell) {
    return this.editor.drawing.contains(cell);
  }

  move() {}

  end(cell) {
    const {editor, kind} = this;
    editor.add(kind, {name: editor.newName(kind), ...editor.drawing.centre(cell)});
  }

  cancel() {}
}

/** Selects what is there and moves it by whole cells. */
class Select {
  needsTwo = true;
  #from;
  #last;

  constructor(editor) {
    this.editor = editor;
  }

  start(cell) {
    const found = this.editor.thingAt(cell);
    this.editor.select(found);
    this.#from = found && cell;
    this.#last = cell;
    return found !== undefined;
  }

  move(cell) {
    this.#last = cell;
    this.editor.redraw();
  }

  end(cell) {
    this.#last = cell;
    const {moved} = this;
    this.cancel();
    if (moved) {
      const {kind, index, thing} = moved;
      this.editor.change({kind, index}, thing);
      this.editor.say(text('editor.said.moved', this.editor.nameOf(moved)));
    }
  }

  cancel() {
    this.#from = undefined;
    this.editor.redraw();
  }

  /** The thing as it would be moved to; undefined where it stays. */
  get moved() {
    const selected = this.#from && this.editor.selected;
    if (!selected) {
      return undefined;
    }
    const {resolution} = this.editor.drawing.grid;
    const columns = this.#last.column - this.#from.column;
    const rows = this.#last.row - this.#from.row;
    if (columns === 0 && rows === 0) {
      return undefined;
    }
    const {x, y} = selected.thing;
    const thing = {...selected.thing, x: rounded(x + columns * resolution), y: rounded(y - rows * resolution)};
    return {...selected, thing};
  }
}

/** Tells how far it is from one cell to another, as the crow flies. */
class Measure extends Span {
  constructor(editor) {
    super(editor, () => {}, () => undefined);
  }

  move(cell) {
    super.move(cell);
    this.#say(this.anchor, cell);
  }

  end(cell) {
    const {anchor} = this;
    this.cancel();
    this.line = [anchor, cell];
    this.#say(anchor, cell);
  }

  start(cell) {
    this.line = undefined;
    return super.start(cell);
  }

  /** The two cells between which was measured last, or is now. */
  get ends() {
    return this.anchor ? [this.anchor, this.last] : this.line;
  }

  #say(a, b) {
    const metres = Math.hypot(a.column - b.column, a.row - b.row) * this.editor.drawing.grid.resolution;
    this.editor.say(text('editor.said.measured', metres.toFixed(2)));
  }
}

/** All tools by their names. */
export function createTools(editor) {
  const {options} = editor;
  const frame = (box) => widened(outlineOf(box), options.width);
  return {
    select: new Select(editor),
    wall: new Brush(editor, true),
    line: walls(editor, (a, b) => widened(lineOf(a, b), options.width)),
    rectangle: walls(
      editor,
      (a, b) => (options.isFilled ? cellsOf : frame)(boxOf(a, b)),
      (a, b) => (options.isFilled ? {box: boxOf(a, b)} : {cells: [...frame(boxOf(a, b))]}),
    ),
    erase: new Brush(editor, false),
    eraseRectangle: eraser(editor),
    keepOut: area(editor, 'keepOut', {}),
    speedLimits: area(editor, 'speedLimits', {speed: 0.2}),
    oneWay: area(editor, 'oneWay', {direction: 'east'}),
    freeZones: area(editor, 'freeZones', {}),
    stations: new PlaceTool(editor, 'stations'),
    parking: new PlaceTool(editor, 'parking'),
    charging: new PlaceTool(editor, 'charging'),
    measure: new Measure(editor),
  };
}

/** What lies at a cell, places before areas and the newest first; undefined where nothing does. */
export function findThing(drawing, cell) {
  const found = [...drawing.all()].reverse().filter((thing) => covers(drawing, thing, cell));
  return found.find(({kind}) => isPlace(kind)) ?? found[0];
}

/** Whether a thing is at a cell. */
export function covers(drawing, {kind, thing}, cell) {
  if (isPlace(kind)) {
    const at = drawing.cellAt(thing.x, thing.y);
    return at.column === cell.column && at.row === cell.row;
  }
  const {x, y} = drawing.centre(cell);
  const half = drawing.grid.resolution / 2; // also what is narrower than a cell
  return x > thing.x - half && x < thing.x + thing.width + half && y > thing.y - half && y < thing.y + thing.height + half;
}
