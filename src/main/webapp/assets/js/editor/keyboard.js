const STEPS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
const FAR = 10; // cells, with the shift key

/** Draws by the keyboard: a cursor that arrow keys move from cell to cell, and keys that apply the tool there. */
export class Keyboard {
  cursor; // a cell, while the keyboard is used
  #editor;
  #isDrawing = false; // whether a tool has begun and not ended

  constructor(editor, canvas) {
    this.#editor = editor;
    canvas.addEventListener('keydown', (event) => this.#press(event));
    document.addEventListener('keydown', (event) => this.#pressAnywhere(event));
  }

  /** The pointer is used, or another tool. */
  leave() {
    if (this.#isDrawing) {
      this.#isDrawing = false;
      this.#editor.tool.cancel();
    }
    this.cursor = undefined;
  }

  #press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    const keys = {
      Enter: () => this.#apply(),
      ' ': () => this.#apply(),
      Escape: () => this.#cancel(),
      Delete: () => this.#remove(),
      Backspace: () => this.#remove(),
    };
    const step = STEPS[event.key];
    if (step) {
      const cells = event.shiftKey ? FAR : 1;
      this.#move(step[0] * cells, step[1] * cells);
    } else if (keys[event.key]) {
      keys[event.key]();
    } else {
      return;
    }
    event.preventDefault();
  }

  #pressAnywhere(event) {
    if (!(event.ctrlKey || event.metaKey) || event.target.matches('input, select, textarea')) {
      return;
    }
    const key = event.key.toLowerCase();
    if (key === 'z' || key === 'y') {
      event.preventDefault();
      this.#editor.step(key === 'y' || event.shiftKey ? 'redo' : 'undo');
    }
  }

  #move(columns, rows) {
    const {width, height} = this.#editor.drawing.grid;
    const from = this.cursor ?? this.#editor.middle;
    const [column, row] = this.cursor ? [from.column + columns, from.row + rows] : [from.column, from.row];
    this.cursor = {
      column: Math.min(width - 1, Math.max(0, column)),
      row: Math.min(height - 1, Math.max(0, row)),
    };
    if (this.#isDrawing) {
      this.#editor.tool.move(this.cursor);
    }
    this.#editor.showCell(this.cursor);
    this.#editor.sayCell(this.cursor);
  }

  #apply() {
    const {tool} = this.#editor;
    this.cursor ??= this.#editor.middle;
    if (this.#isDrawing) {
      this.#isDrawing = false;
      tool.end(this.cursor);
    } else if (tool.start(this.cursor)) {
      if (tool.needsTwo) {
        this.#isDrawing = true;
        this.#editor.sayBegun();
      } else {
        tool.end(this.cursor);
      }
    } else {
      this.#editor.sayCell(this.cursor);
    }
    this.#editor.redraw();
  }

  #cancel() {
    if (this.#isDrawing) {
      this.#isDrawing = false;
      this.#editor.tool.cancel();
      this.#editor.sayCancelled();
    } else {
      this.#editor.select(undefined);
    }
  }

  #remove() {
    if (this.cursor && !this.#editor.selected) {
      this.#editor.select(this.#editor.thingAt(this.cursor));
    }
    this.#editor.removeSelected();
  }
}
