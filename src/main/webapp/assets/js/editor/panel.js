import {createElement, setText, updateList} from '../shared/elements.js';
import {numberIn} from '../shared/locale.js';
import {text} from '../shared/texts.js';
import {isPlace} from './drawing.js';

const FARTHEST = 100_000; // metres

/** What the server takes for no name either (CleanText, GivenName): what cannot be shown, and what shows nothing. */
const UNSHOWN = /[\p{Cc}\p{Cs}\p{Zl}\p{Zp}\p{Co}\p{Cn}]|(?![\u200c\u200d])\p{Cf}/u;
const SHOWN = /[^\s\p{Z}\p{Cf}]/u;

/** The fields of each kind of thing. */
const FIELDS = {
  stations: ['name', 'x', 'y', 'headingDegrees', 'approach'],
  parking: ['name', 'x', 'y', 'headingDegrees', 'approach'],
  charging: ['name', 'x', 'y', 'headingDegrees', 'approach'],
  keepOut: ['x', 'y', 'width', 'height'],
  speedLimits: ['speed', 'x', 'y', 'width', 'height'],
  oneWay: ['direction', 'x', 'y', 'width', 'height'],
  freeZones: ['x', 'y', 'width', 'height'],
};

/** From and to of the fields that are numbers. */
const RANGES = {
  x: [-FARTHEST, FARTHEST],
  y: [-FARTHEST, FARTHEST],
  width: [1e-6, 2 * FARTHEST],
  height: [1e-6, 2 * FARTHEST],
  headingDegrees: [-360, 360],
};

/** The fields of what is selected, and a list of all things. */
export class Panel {
  #editor;
  #shown; // which thing's fields
  #section = document.querySelector('#selected');
  #list = document.querySelector('#things');
  #error = document.querySelector('#thing-error');

  constructor(editor) {
    this.#editor = editor;
    const {slowest, fastest, longestName} = this.#section.dataset;
    this.ranges = {...RANGES, speed: [Number(slowest), Number(fastest)]};
    this.longestName = Number(longestName);
    for (const input of this.#inputs) {
      input.addEventListener('change', () => this.#read(input));
    }
    document.querySelector('#thing-delete').addEventListener('click', () => this.#editor.removeSelected());
  }

  get #inputs() {
    return this.#section.querySelectorAll('[data-field]');
  }

  /** Shows what is selected and all things as they are now. */
  update() {
    const {selected, drawing} = this.#editor;
    this.#section.hidden = !selected;
    if (selected) {
      this.#fill(selected);
    } else {
      this.#shown = undefined;
    }
    const things = [...drawing.all()];
    document.querySelector('#no-things').hidden = things.length > 0;
    updateList(
      this.#list,
      things,
      ({kind, index}) => `${kind} ${index}`,
      () => createElement('li', '', createElement('button', 'thing')),
      (item, found) => this.#fillItem(item.firstChild, found),
    );
  }

  /** What is being typed stays, until something else is selected. */
  #fill({kind, index, thing}) {
    const isOther = this.#shown !== `${kind} ${index}`;
    this.#shown = `${kind} ${index}`;
    setText(this.#section.querySelector('h2 span'), text(`editor.kind.${kind}`));
    for (const input of this.#inputs) {
      const {field} = input.dataset;
      input.closest('.thing-field').hidden = !FIELDS[kind].includes(field);
      if (input === document.activeElement && !isOther) {
        continue;
      }
      const value = thing[field];
      input.value = value === undefined || value === null ? '' : String(typeof value === 'number' ? Number(value.toFixed(6)) : value);
      input.removeAttribute('aria-invalid');
    }
    setText(this.#error, '');
  }

  #fillItem(button, {kind, index, thing}) {
    button.type = 'button';
    setText(button, this.#editor.describe({kind, thing}));
    const {selected} = this.#editor;
    button.setAttribute('aria-pressed', String(selected?.kind === kind && selected.index === index));
    button.onclick = () => {
      this.#editor.select({kind, index, thing});
      this.#editor.show(thing);
    };
  }

  /** Takes what was typed, if it can be so. */
  #read(input) {
    const {selected} = this.#editor;
    if (!selected) {
      return;
    }
    const {field} = input.dataset;
    const [value, fault] = this.#valueOf(input, field, selected);
    if (fault !== undefined) {
      input.setAttribute('aria-invalid', 'true');
      setText(this.#error, fault);
      return;
    }
    input.removeAttribute('aria-invalid');
    const thing = {...selected.thing, [field]: value};
    if (value === undefined) {
      delete thing[field];
    }
    this.#editor.change(selected, thing);
  }

  /** The value of a field, and what is wrong with it. */
  #valueOf(input, field, selected) {
    if (field === 'name') {
      return this.#nameIn(input, selected);
    }
    if (field === 'approach' || field === 'direction') {
      return [input.value || undefined];
    }
    if (field === 'headingDegrees' && input.value.trim() === '') {
      return [undefined];
    }
    const [least, most] = this.ranges[field];
    const value = numberIn(input);
    return value === undefined || value < least || value > most
      ? [undefined, text('editor.error.number', Math.round(least * 1000) / 1000, most)]
      : [value];
  }

  #nameIn(input, {kind, index}) {
    const name = input.value.trim();
    if (!SHOWN.test(name) || UNSHOWN.test(name) || [...name].length > this.longestName) {
      return [undefined, text('editor.error.name', this.longestName)];
    }
    const isTaken = [...this.#editor.drawing.all()].some(
      (other) => isPlace(other.kind) && other.thing.name === name && !(other.kind === kind && other.index === index));
    return isTaken ? [undefined, text('editor.error.nameTwice', name)] : [name];
  }
}
