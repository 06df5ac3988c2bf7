import {createElement, setText, updateList} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';

const FIRST_STATES = [ // others follow them
  'ERROR', 'NOT_LOCALISED', 'LOST', 'CONNECTING', 'OUT_OF_SERVICE', 'HOLDING', 'CHARGING', 'DRIVING',
  'IDLE',
];
const whole = new Intl.NumberFormat(locale);

/** How many robots are in each state, as buttons that filter the robots by state. */
export class StateFilter {
  #list;
  #onChange;
  #selected = new Set(); // states; none: all robots are shown

  constructor(list, onChange) {
    this.#list = list;
    this.#onChange = onChange;
  }

  includes({state}) {
    return this.#selected.size === 0 || this.#selected.has(state);
  }

  update(robots) {
    const counts = [...new Set([...FIRST_STATES, ...robots.map(({state}) => state), ...this.#selected])]
      .map((state) => ({state, count: robots.filter((robot) => robot.state === state).length}))
      .filter(({state, count}) => count > 0 || this.#selected.has(state));
    updateList(this.#list, counts, ({state}) => state, ({state}) => this.#createButton(state), (item, {state, count}) => {
      setText(item.querySelector('b'), whole.format(count));
      item.querySelector('button').ariaPressed = this.#selected.has(state);
    });
  }

  #createButton(state) {
    const letter = createElement('span', 'letter', text(`robot.letter.${state}`));
    letter.dataset.state = state;
    letter.ariaHidden = 'true';
    const label = createElement('span', '', text(`robot.state.${state}`));
    const button = createElement('button', '', letter, createElement('b'), ' ', label);
    button.type = 'button';
    button.addEventListener('click', () => this.#toggle(state));
    return createElement('li', '', button);
  }

  #toggle(state) {
    if (!this.#selected.delete(state)) {
      this.#selected.add(state);
    }
    this.#onChange();
  }
}
