import {setText} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';

const $ = (selector) => document.querySelector(selector);
const time = new Intl.DateTimeFormat(locale, {timeStyle: 'medium'});

/** Somebody else has changed the draft: the user loads theirs, or saves his own over it. */
export class Conflict {
  #theirs;

  constructor(editor, draft) {
    $('#conflict-load').addEventListener('click', () => {
      this.#close();
      editor.edits.replace(this.#theirs.drawing); // what was drawn here comes back by undo
      draft.accept(this.#theirs);
      editor.say(text('editor.conflict.loaded'));
    });
    $('#conflict-keep').addEventListener('click', () => {
      this.#close();
      draft.replace(this.#theirs);
      editor.say(text('editor.conflict.kept'));
    });
    $('#conflict').addEventListener('cancel', (event) => event.preventDefault()); // one of the two it must be
  }

  /** @param theirs their draft; without a user where it was published or discarded */
  meet(theirs) {
    this.#theirs = theirs;
    const {user, at} = theirs;
    setText(
      $('#conflict-who'),
      user ? text('editor.conflict.changed', user, time.format(new Date(at))) : text('editor.conflict.gone'));
    if (!$('#conflict').open) {
      $('#conflict').showModal();
    }
  }

  #close() {
    $('#conflict').close();
  }
}
