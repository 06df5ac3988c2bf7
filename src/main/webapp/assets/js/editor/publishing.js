import {createElement, setText} from '../shared/elements.js';
import {fetchJson, send} from '../shared/server.js';
import {text} from '../shared/texts.js';
import {Difference} from './difference.js';
import {reasonOf} from './draft.js';

const $ = (selector) => document.querySelector(selector);

/** Checks the draft and puts it in force; shows what it changes. */
export class Publishing {
  inForce; // json of the drawing that is in force
  problems = [];
  difference; // while it is shown
  #editor;
  #draft;
  #floor;
  #changes = 0; // of the drawing

  constructor(editor, draft, floor) {
    this.#editor = editor;
    this.#draft = draft;
    this.#floor = floor;
    $('#check').addEventListener('click', () => this.#check());
    $('#publish').addEventListener('click', () => this.#ask());
    $('#publish-sure').addEventListener('click', () => this.#publish());
    $('#discard').addEventListener('click', () => $('#discarding').showModal());
    $('#discard-sure').addEventListener('click', () => this.#discard());
    $('#difference').addEventListener('click', () => this.#toggleDifference());
    for (const button of document.querySelectorAll('dialog [data-close]')) {
      button.addEventListener('click', () => button.closest('dialog').close());
    }
  }

  async load() {
    ({drawing: this.inForce} = await fetchJson(`api/v1/floors/${encodeURIComponent(this.#floor)}`));
    this.update();
  }

  /** After the drawing has changed. */
  update() {
    this.#changes++;
    this.#outdateProblems();
    if (this.difference) {
      this.#showDifference();
    }
  }

  /** What was found is true of an older drawing: its list stays, to go on by, but marks nothing any more. */
  #outdateProblems() {
    this.problems = [];
    if ($('#problem-list').childElementCount === 0) {
      $('#problems').hidden = true;
    } else {
      setText($('#problems-summary'), text('editor.problems.outdated'));
    }
  }

  /** Answers whether the server has checked it as it is now. */
  async #check() {
    this.#editor.say(text('editor.checking'));
    const checked = this.#changes;
    const {status, body} = await send('POST', `${this.#draft.path}/check`, {drawing: this.#editor.drawing.toJson()});
    if (status !== 200) {
      this.#showProblems([], reasonOf(status, body));
      return false;
    }
    if (this.#changes !== checked) {
      this.#showProblems(body, text('editor.changedMeanwhile'));
      this.problems = [];
      this.#editor.redraw();
      return false;
    }
    this.#showProblems(body, body.length === 0 ? text('editor.noProblems') : text('editor.problems.count', body.length));
    return true;
  }

  #showProblems(problems, summary) {
    this.problems = problems;
    $('#problems').hidden = false;
    setText($('#problems-summary'), summary);
    this.#editor.say(summary);
    $('#problem-list').replaceChildren(...problems.map((problem) => this.#item(problem)));
    this.#editor.redraw();
  }

  #item({text: words, where, blocking}) {
    const label = createElement('strong', '', text(blocking ? 'editor.problem.blocking' : 'editor.problem.warning'));
    const content = createElement('bdi', '', words);
    if (!where) {
      return createElement('li', '', label, ' ', content);
    }
    const button = createElement('button', 'thing', label, ' ', content);
    button.type = 'button';
    button.addEventListener('click', () => this.#editor.show(where));
    return createElement('li', '', button);
  }

  async #ask() {
    const saved = this.#changes;
    if (!(await this.#draft.save())) {
      this.#editor.say(text(this.#changes === saved ? 'editor.publish.unsaved' : 'editor.changedMeanwhile'));
      return;
    }
    if (!(await this.#check()) || this.problems.some(({blocking}) => blocking)) {
      return;
    }
    const difference = new Difference(this.#editor.drawing, this.inForce);
    setText($('#publish-changes'), this.#summary(difference));
    $('#publish-warnings').hidden = this.problems.length === 0;
    $('#publishing').showModal();
  }

  async #publish() {
    $('#publishing').close();
    const {status, body} = await send('POST', `${this.#draft.path}/publish`, {revision: this.#draft.revision});
    if (status === 200) {
      await this.#draft.load();
      await this.load();
      this.#showProblems([], text('editor.published'));
    } else {
      this.#showProblems(body?.problems ?? [], reasonOf(status, body));
    }
  }

  async #discard() {
    $('#discarding').close();
    const {status, body} = await send('DELETE', `${this.#draft.path}?revision=${this.#draft.revision}`);
    if (status === 204) {
      const now = await this.#draft.load();
      this.#editor.edits.replace(now.drawing);
      this.#draft.accept(now);
      this.#editor.say(text('editor.discarded'));
    } else {
      this.#editor.say(reasonOf(status, body));
    }
  }

  #toggleDifference() {
    const isOn = this.difference === undefined;
    $('#difference').setAttribute('aria-pressed', String(isOn));
    $('#changes').hidden = !isOn;
    this.difference = undefined;
    if (isOn) {
      this.#showDifference();
      this.#editor.say($('#changes-summary').textContent);
    }
    this.#editor.redraw();
  }

  #showDifference() {
    this.difference = new Difference(this.#editor.drawing, this.inForce);
    setText($('#changes-summary'), this.#summary(this.difference));
    $('#change-list').replaceChildren(
      ...this.difference.things.map(({kind, change, thing}) =>
        createElement('li', '', text(`editor.change.${change}`, this.#editor.describe({kind, thing})))));
  }

  #summary(difference) {
    if (difference.isOtherGrid) {
      return text('editor.changes.otherGrid');
    }
    if (difference.isEmpty) {
      return text('editor.changes.none');
    }
    const {addedCount, removedCount, things, moves} = difference;
    const drawn = text('editor.changes', addedCount, removedCount, things.length);
    return moves ? text('editor.changes.moves', drawn, text(`editor.moves.${moves}`)) : drawn;
  }
}
