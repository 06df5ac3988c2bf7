/** A button that shows something on the map, or no longer. */
export class Switch {
  #button;

  constructor(button, canvas) {
    this.#button = button;
    button.addEventListener('click', () => {
      button.setAttribute('aria-pressed', String(!this.isOn));
      canvas.requestFrame();
    });
  }

  get isOn() {
    return this.#button.getAttribute('aria-pressed') === 'true';
  }
}
