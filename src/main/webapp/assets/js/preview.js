import {locale} from './locale.js';
import {address} from './server.js';
import {text} from './texts.js';

const PAUSE = 400; // milliseconds without a change

/**
 * Asks the server what would become of the task in a form, whenever the form rests, and says it.
 */
export class Preview {
  #form;
  #output;
  #order;
  #onWay;
  #timer;
  #asked = 0;

  /**
   * @param order answers what to ask for, or nothing while the form is not ready
   * @param onWay is given the points of the load's way, none while there is no answer
   */
  constructor(form, output, order, onWay) {
    this.#form = form;
    this.#output = output;
    this.#order = order;
    this.#onWay = onWay;
    form.addEventListener('input', () => this.changed());
    form.addEventListener('change', () => this.changed());
  }

  changed() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#ask(), PAUSE);
  }

  async #ask() {
    const asked = ++this.#asked;
    const order = this.#order();
    const answer = order && await this.#answer(order);
    if (asked === this.#asked) {
      this.#output.textContent = answer?.sentence ?? '';
      this.#output.hidden = !answer?.sentence;
      this.#output.classList.toggle('wrong', answer?.wrong ?? false);
      this.#onWay(answer?.way ?? []);
    }
  }

  async #answer(order) {
    try {
      const answer = await fetch(address('api/v1/tasks/preview'), {
        method: 'POST',
        headers: {'content-type': 'application/json', 'X-CSRF-Token': this.#form.elements._csrf.value},
        body: JSON.stringify(order),
      });
      const said = await answer.json();
      return answer.ok
        ? {sentence: sentence(said), way: said.way}
        : {sentence: answer.status === 422 ? said.detail : '', wrong: true};
    } catch {
      return undefined; // the form works without
    }
  }
}

function about(metres) {
  const digits = metres < 10 ? 1 : 0;
  return new Intl.NumberFormat(
    locale, {minimumFractionDigits: digits, maximumFractionDigits: digits}).format(metres);
}

function sentence({robots, chosen, reason, metres}) {
  const sentences = [];
  if (robots > 1) {
    sentences.push(text('newTask.preview.needs', robots));
  }
  sentences.push(
    chosen.length > 0
      ? text('newTask.preview.chosen', chosen.join(text('common.comma')), reason)
      : text('newTask.preview.waits', reason));
  if (metres > 0) {
    sentences.push(text('newTask.preview.metres', about(metres)));
  }
  return sentences.join(' ');
}
