/**
 * What managers can do with floors stands beside the live map; only that of the floor shown is
 * wanted.
 */
export class FloorActions {
  #list;
  #floor;

  /** @param list holds the actions; they may be replaced at any time */
  constructor(list) {
    this.#list = list;
    new MutationObserver(() => this.#update()).observe(list, {childList: true, subtree: true});
  }

  /** @param floor the name of the floor that is shown */
  show(floor) {
    this.#floor = floor;
    this.#update();
  }

  #update() {
    for (const part of this.#list.querySelectorAll('[data-floor]')) {
      part.hidden = part.dataset.floor !== this.#floor;
    }
  }
}
