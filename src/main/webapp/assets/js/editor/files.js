import {setText} from '../shared/elements.js';
import {numberIn} from '../shared/locale.js';
import {send} from '../shared/server.js';
import {text} from '../shared/texts.js';
import {reasonOf} from './draft.js';

const $ = (selector) => document.querySelector(selector);
const MEDIA_TYPES = {zip: 'application/zip', png: 'image/png', map: 'text/plain'};
const SIDES = ['left', 'right', 'top', 'bottom'];
const MOST_CELLS = 1 << 24;

/** Reads a file into the drawing, and gives it more or fewer cells. */
export class Files {
  #editor;

  constructor(editor) {
    this.#editor = editor;
    $('#import').addEventListener('click', () => this.#import());
    $('#resize').addEventListener('click', () => this.#resize());
  }

  async #import() {
    const [file] = $('#import-file').files;
    const type = MEDIA_TYPES[file?.name.split('.').pop().toLowerCase()];
    if (!type) {
      setText($('#import-said'), text('editor.import.choose'));
      return;
    }
    setText($('#import-said'), text('editor.import.reading'));
    const query = new URLSearchParams({file: file.name});
    const resolution = numberIn($('#import-resolution'));
    if (type === 'image/png' && resolution !== undefined) {
      query.set('resolution', resolution);
      query.set('threshold', (numberIn($('#import-threshold')) ?? 50) / 100);
    }
    const {status, body} = await send('POST', `api/v1/floors/read?${query}`, file, type);
    if (status !== 200) {
      setText($('#import-said'), reasonOf(status, body));
      return;
    }
    this.#editor.edits.replace(body);
    this.#editor.fit();
    setText($('#import-said'), text('editor.import.done', body.width, body.height));
  }

  #resize() {
    const more = Object.fromEntries(SIDES.map((side) => [side, numberIn($(`#resize-${side}`)) ?? 0]));
    const {width, height} = this.#editor.drawing.grid;
    const [columns, rows] = [width + more.left + more.right, height + more.top + more.bottom];
    const isWhole = SIDES.every((side) => Number.isInteger(more[side]));
    if (!isWhole || columns < 1 || rows < 1 || columns * rows > MOST_CELLS) {
      setText($('#resize-said'), text('editor.resize.wrong', MOST_CELLS));
      return;
    }
    this.#editor.edits.replace(this.#editor.drawing.resized(more));
    this.#editor.fit();
    setText($('#resize-said'), text('editor.resize.done', columns, rows));
  }
}
