import {fetchJson, send} from '../shared/server.js';
import {text} from '../shared/texts.js';

const PAUSE = 800; // milliseconds after the last change until it is saved
const RETRY = 5_000; // milliseconds until it is tried again
const CHANGED = 412;

/** Keeps the draft on the server as it is drawn: saves it a moment after each change, again and again until it is. */
export class Draft {
  #path;
  #revision = 0;
  #isDirty = false;
  #isConflicting = false; // somebody else has changed it, and nothing is saved until the user has chosen
  #saving; // a promise, while it is being saved
  #timer;
  #drawing;
  #show;
  #onConflict;

  /**
   * @param drawing answers what is to be saved
   * @param show called with saved, saving or unsaved, and the reason
   * @param onConflict called with the draft of somebody else
   */
  constructor(floor, drawing, show, onConflict) {
    this.#path = `api/v1/floors/${encodeURIComponent(floor)}/draft`;
    this.#drawing = drawing;
    this.#show = show;
    this.#onConflict = onConflict;
    addEventListener('beforeunload', (event) => {
      if (!this.isSaved) {
        event.preventDefault();
      }
    });
    addEventListener('online', () => this.save());
  }

  get path() {
    return this.#path;
  }

  get revision() {
    return this.#revision;
  }

  get isSaved() {
    return !this.#isDirty && !this.#saving;
  }

  /** The draft as it is on the server, from which is gone on. */
  async load() {
    const draft = await fetchJson(this.#path);
    this.accept(draft);
    return draft;
  }

  /** Goes on from a draft of the server; nobody has changed it where there is none. */
  accept({revision, user}) {
    this.#revision = revision;
    this.#isDirty = false;
    this.#isConflicting = false;
    clearTimeout(this.#timer);
    this.#show(user ? 'saved' : 'none');
  }

  /** Saves what is drawn over the draft of somebody else. */
  replace({revision}) {
    this.#revision = revision;
    this.#isConflicting = false;
    this.#isDirty = true;
    return this.save();
  }

  markChanged() {
    this.#isDirty = true;
    this.#show(this.#isConflicting ? 'conflict' : 'saving');
    this.#schedule(PAUSE);
  }

  /** Saves what has changed; answers whether all of it is saved. */
  async save() {
    clearTimeout(this.#timer);
    while (this.#saving) {
      await this.#saving;
    }
    if (!this.#isDirty || this.#isConflicting) {
      return !this.#isDirty;
    }
    this.#saving = this.#send();
    const isSaved = await this.#saving;
    this.#saving = undefined;
    return isSaved && !this.#isDirty;
  }

  async #send() {
    this.#isDirty = false;
    this.#show('saving');
    const {status, body} = await send('PUT', this.#path, {revision: this.#revision, drawing: this.#drawing()});
    if (status === 200) {
      this.#revision = body.revision;
      this.#show(this.#isDirty ? 'saving' : 'saved');
      return true;
    }
    this.#isDirty = true;
    if (status === CHANGED) {
      await this.#meet();
    } else {
      this.#show('unsaved', reasonOf(status, body));
      if (status === 0 || status === 401 || status === 429 || status >= 500) {
        this.#schedule(RETRY);
      }
    }
    return false;
  }

  async #meet() {
    this.#show('conflict');
    try {
      const theirs = await fetchJson(this.#path);
      this.#isConflicting = true;
      this.#onConflict(theirs);
    } catch {
      this.#schedule(RETRY);
    }
  }

  #schedule(delay) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.save(), delay);
  }
}

/** Why the server has not done something. */
export function reasonOf(status, body) {
  if (status === 401) {
    return text('map.loggedOut');
  }
  return body?.detail ?? text('editor.away');
}
