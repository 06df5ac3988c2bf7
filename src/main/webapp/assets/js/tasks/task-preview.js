import {roundedMetres} from '../shared/locale.js';
import {address} from '../shared/server.js';
import {text} from '../shared/texts.js';

const DELAY = 400; // milliseconds without a change of the form
const TOLD = new Set([422, 429, 503]); // refusals of which the person who fills in the form should know

/** Shows the server's estimate for the task in a form, after each change of the form. */
export class TaskPreview {
  #form;
  #output;
  #order;
  #onPath;
  #timer;
  #requests = 0;

  /**
   * @param order answers the task as the API takes it, undefined while the form is incomplete
   * @param onPath called with the points of the load's path, none while there is no answer
   */
  constructor(form, output, order, onPath) {
    this.#form = form;
    this.#output = output;
    this.#order = order;
    this.#onPath = onPath;
    form.addEventListener('input', () => this.request());
    form.addEventListener('change', () => this.request());
  }

  /** Asks the server as soon as the form has not changed for a moment. */
  request() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#update(), DELAY);
  }

  async #update() {
    const request = ++this.#requests;
    const order = this.#order();
    const answer = order && await this.#fetch(order);
    if (request === this.#requests) {
      this.#output.textContent = answer?.sentence ?? '';
      this.#output.hidden = !answer?.sentence;
      this.#output.classList.toggle('wrong', answer?.wrong ?? false);
      this.#onPath(answer?.path ?? []);
    }
  }

  async #fetch(order) {
    try {
      const answer = await fetch(address('api/v1/tasks/preview'), {
        method: 'POST',
        headers: {'content-type': 'application/json', 'X-CSRF-Token': this.#form.elements._csrf.value},
        body: JSON.stringify(order),
      });
      const body = await answer.json();
      return answer.ok
        ? {sentence: sentence(body, order.kind === 'DRIVE'), path: body.way}
        : {sentence: TOLD.has(answer.status) ? body.detail : '', wrong: true};
    } catch {
      return undefined; // the form works without a preview
    }
  }
}

function sentence({robots, chosen, reason, metres}, isDrive) {
  const sentences = [];
  if (robots > 1) {
    sentences.push(text('newTask.preview.needs', robots));
  }
  sentences.push(
    chosen.length > 0
      ? text('newTask.preview.chosen', chosen.join(text('common.comma')), reason)
      : text('newTask.preview.waits', reason));
  if (metres > 0) {
    sentences.push(text(`newTask.preview.${isDrive ? 'driven' : 'metres'}`, roundedMetres(metres)));
  }
  return sentences.join(' ');
}
