import {FloorCanvas} from '../floor/floor-canvas.js';
import {listenForZoomButtons} from '../floor/zoom-buttons.js';
import {setText} from '../shared/elements.js';
import '../shared/live.js';
import {numberIn} from '../shared/locale.js';
import {text} from '../shared/texts.js';
import {Conflict} from './conflict.js';
import {Draft} from './draft.js';
import {isPlace} from './drawing.js';
import {Edits} from './edits.js';
import {Files} from './files.js';
import {Keyboard} from './keyboard.js';
import {Painter} from './painter.js';
import {Panel} from './panel.js';
import {Publishing} from './publishing.js';
import {covers, createTools, findThing} from './tools.js';

const $ = (selector) => document.querySelector(selector);
const WIDEST = 50; // cells of a brush
const EDGE = 10; // pixels of the canvas that do not count as seen

/** The page on which a floor is drawn. */
class Editor {
  options = {width: 1, isFilled: false};
  edits; // undefined until the draft is loaded
  tool;
  #floor = $('#map').dataset.floor;
  #selected; // {kind, index}
  #painter = new Painter();
  #tools = createTools(this);
  #keyboard = new Keyboard(this, $('#map')); // before the canvas, whose keys it takes over
  #canvas = new FloorCanvas($('#map'), this.#draw.bind(this), undefined, {
    start: (x, y) => this.#start(x, y),
    move: (x, y) => this.tool.move(this.#cellAt(x, y)),
    end: (x, y) => this.tool.end(this.#cellAt(x, y)),
    cancel: () => this.tool.cancel(),
  });

  #draft = new Draft(
    this.#floor,
    () => this.drawing.toJson(),
    (state, reason) => showSaved(state, reason),
    (theirs) => this.#conflict.meet(theirs),
  );

  #conflict = new Conflict(this, this.#draft);
  #publishing = new Publishing(this, this.#draft, this.#floor);
  #panel = new Panel(this);

  async start() {
    new Files(this);
    listenForZoomButtons(this.#canvas);
    this.#listenForTools();
    this.choose('select');
    try {
      const {drawing} = await this.#draft.load();
      await this.#publishing.load();
      this.edits = new Edits(drawing, (cells, isStep) => this.#changed(cells, isStep));
    } catch {
      $('#load-failed').hidden = false;
      return;
    }
    this.#showAll();
    this.fit();
  }

  get drawing() {
    return this.edits.drawing;
  }

  /** What is selected, as it is now: {kind, index, thing}. */
  get selected() {
    const thing = this.#selected && this.drawing.things[this.#selected.kind][this.#selected.index];
    return thing && {...this.#selected, thing};
  }

  /** The cell in the middle of what the canvas shows. */
  get middle() {
    const {viewport} = this.#canvas;
    const {width, height} = this.drawing.grid;
    const {column, row} = this.drawing.cellAt(viewport.x, viewport.y);
    return {column: Math.min(width - 1, Math.max(0, column)), row: Math.min(height - 1, Math.max(0, row))};
  }

  choose(name) {
    this.#keyboard.leave();
    this.tool = this.#tools[name];
    for (const button of document.querySelectorAll('[data-tool]')) {
      button.setAttribute('aria-pressed', String(button.dataset.tool === name));
    }
    $('#brush-width-field').hidden = !['wall', 'line', 'rectangle', 'erase'].includes(name);
    $('#filled-field').hidden = name !== 'rectangle';
    this.redraw();
  }

  select(found) {
    this.#selected = found && {kind: found.kind, index: found.index};
    this.#panel.update();
    if (found) {
      this.say(text('editor.said.selected', this.describe(this.selected)));
    }
    this.redraw();
  }

  add(kind, thing) {
    const things = [...this.drawing.things[kind], thing];
    this.#selected = {kind, index: things.length - 1};
    this.edits.setThings({[kind]: things});
    this.say(text('editor.said.added', this.describe({kind, thing})));
  }

  /** Replaces a thing by another one. */
  change({kind, index}, thing) {
    this.edits.setThings({[kind]: this.drawing.things[kind].with(index, thing)});
  }

  removeSelected() {
    const {selected} = this;
    if (selected) {
      const {kind, index} = selected;
      this.#selected = undefined;
      this.edits.setThings({[kind]: this.drawing.things[kind].toSpliced(index, 1)});
      this.say(text('editor.said.removed', this.describe(selected)));
    }
  }

  /** @param way undo or redo */
  step(way) {
    if (way === 'undo' ? this.edits.canUndo : this.edits.canRedo) {
      this.#keyboard.leave();
      this.edits[way]();
      this.say(text(`editor.said.${way}`));
    }
  }

  thingAt(cell) {
    return findThing(this.drawing, cell);
  }

  newName(kind) {
    const taken = new Set([...this.drawing.all()].map(({thing}) => thing.name));
    for (let number = 1; ; number++) {
      const name = text(`editor.newName.${kind}`, number);
      if (!taken.has(name)) {
        return name;
      }
    }
  }

  nameOf({kind, thing}) {
    return thing.name ?? text(`editor.kind.${kind}`);
  }

  /** What a thing is, for people. */
  describe({kind, thing}) {
    const at = text('common.position', metres(thing.x), metres(thing.y));
    const what = text(`editor.kind.${kind}`);
    return isPlace(kind)
      ? text('editor.describe.place', what, thing.name, at)
      : text('editor.describe.area', what, text('loads.size', metres(thing.width), metres(thing.height)), at);
  }

  say(words) {
    setText($('#said'), words);
  }

  sayCell(cell) {
    const {x, y} = this.drawing.centre(cell);
    const here = [...this.drawing.all()].filter((found) => covers(this.drawing, found, cell));
    const what = [
      text(this.drawing.isWall(cell) ? 'editor.cell.wall' : 'editor.cell.free'),
      ...here.map((found) => this.nameOf(found)),
    ].join(text('common.comma'));
    this.say(text('editor.cell', metres(x), metres(y), what));
    this.redraw();
  }

  sayBegun() {
    this.say(text('editor.said.begun'));
  }

  sayCancelled() {
    this.say(text('editor.said.cancelled'));
  }

  redraw() {
    this.#canvas.requestFrame();
  }

  fit() {
    this.#canvas.viewport.setBounds(this.drawing.bounds);
    this.redraw();
  }

  /** Brings a point, or the middle of an area, into view. */
  show({x, y, width = 0, height = 0}) {
    const {viewport} = this.#canvas;
    const [px, py] = viewport.toScreen(x + width / 2, y + height / 2);
    if (px < EDGE || py < EDGE || px > viewport.width - EDGE || py > viewport.height - EDGE) {
      viewport.pan(viewport.width / 2 - px, viewport.height / 2 - py);
    }
    this.redraw();
  }

  showCell(cell) {
    this.show(this.drawing.centre(cell));
  }

  #start(x, y) {
    if (!this.edits) {
      return false;
    }
    this.#keyboard.leave();
    return this.tool.start(this.#cellAt(x, y));
  }

  #cellAt(px, py) {
    return this.drawing.cellAt(...this.#canvas.viewport.toMap(px, py));
  }

  #changed(cells, isStep) {
    this.#painter.markChanged(cells);
    if (isStep) {
      this.#draft.markChanged();
      this.#publishing.update();
      this.#showAll();
    }
    if (cells === undefined) {
      this.fit();
    }
    this.redraw();
  }

  #showAll() {
    if (!this.selected) {
      this.#selected = undefined;
    }
    $('#undo').disabled = !this.edits.canUndo;
    $('#redo').disabled = !this.edits.canRedo;
    $('#moves').disabled = false;
    $('#moves').value = this.drawing.moves;
    this.#panel.update();
    const {width, height, resolution} = this.drawing.grid;
    const size = text('loads.size', metres(width * resolution), metres(height * resolution));
    setText($('#size'), `${size} · ${text('editor.size', width, height, String(resolution))}`);
  }

  #listenForTools() {
    for (const button of document.querySelectorAll('[data-tool]')) {
      button.addEventListener('click', () => this.choose(button.dataset.tool));
    }
    $('#undo').addEventListener('click', () => this.step('undo'));
    $('#redo').addEventListener('click', () => this.step('redo'));
    $('#brush-width').addEventListener('change', ({target}) => {
      this.options.width = Math.min(WIDEST, Math.max(1, Math.round(numberIn(target) ?? 1)));
      target.value = this.options.width;
    });
    $('#moves').addEventListener('change', ({target}) => {
      this.edits.setMoves(target.value);
      this.say(text('editor.said.moves', text(`editor.moves.${target.value}`)));
    });
    $('#filled').addEventListener('change', ({target}) => (this.options.isFilled = target.checked));
  }

  #draw(context, viewport, colours) {
    if (this.edits) {
      this.#painter.draw(context, viewport, colours, this.#scene);
    }
    return false;
  }

  get #scene() {
    const {moved} = this.tool;
    const things = moved
      ? {...this.drawing.things, [moved.kind]: this.drawing.things[moved.kind].with(moved.index, moved.thing)}
      : this.drawing.things;
    return {
      drawing: this.drawing,
      things,
      selected: moved ?? this.selected,
      shape: this.tool.shape,
      ends: this.tool.ends,
      cursor: this.#keyboard.cursor,
      marks: this.#publishing.problems.flatMap(({where}) => (where ? [where] : [])),
      difference: this.#publishing.difference,
    };
  }
}

/** To a centimetre. */
function metres(length) {
  return String(Math.round(length * 100) / 100);
}

function showSaved(state, reason) {
  const element = $('#save-state');
  element.dataset.state = state;
  setText(element, state === 'unsaved' ? text('editor.unsaved', reason) : text(`editor.state.${state}`));
}

await new Editor().start();
