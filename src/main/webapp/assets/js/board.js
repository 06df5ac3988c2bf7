import {listenForGestures} from './gestures.js';
import {Viewport} from './viewport.js';

/**
 * A canvas that shows a floor: keeps its size, its colours and its viewport, and draws a frame
 * when one is wanted.
 */
export class Board {
  viewport = new Viewport();
  colours = {};
  #canvas;
  #draw;
  #asked = false;

  /**
   * @param draw called with (context, viewport, colours, now); true asks for the next frame too
   * @param onTap called with the map point of a click, and how many metres a pixel is
   */
  constructor(canvas, draw, onTap) {
    this.#canvas = canvas;
    this.#draw = draw;
    this.#readColours();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      this.#readColours();
      this.refresh();
    });
    new ResizeObserver(() => this.#resize()).observe(canvas);
    listenForGestures(
      canvas,
      this.viewport,
      () => this.refresh(),
      (px, py) => onTap?.(...this.viewport.toMap(px, py), 1 / this.viewport.scale),
    );
  }

  /** Draws with the next frame of the screen. */
  refresh() {
    if (!this.#asked) {
      this.#asked = true;
      requestAnimationFrame((now) => this.#frame(now));
    }
  }

  #frame(now) {
    this.#asked = false;
    const context = this.#canvas.getContext('2d');
    const dots = devicePixelRatio;
    context.setTransform(dots, 0, 0, dots, 0, 0);
    context.clearRect(0, 0, this.viewport.width, this.viewport.height);
    if (this.#draw(context, this.viewport, this.colours, now)) {
      this.refresh();
    }
  }

  #resize() {
    const {clientWidth, clientHeight} = this.#canvas;
    this.#canvas.width = Math.round(clientWidth * devicePixelRatio);
    this.#canvas.height = Math.round(clientHeight * devicePixelRatio);
    this.viewport.resize(clientWidth, clientHeight);
    this.refresh();
  }

  /** The custom properties of the style sheet, by name without the dashes. */
  #readColours() {
    const style = getComputedStyle(document.documentElement);
    const names = [
      'map-free', 'map-wall', 'map-line', 'map-text', 'map-halo', 'map-place', 'map-parking',
      'map-charging', 'map-load', 'map-load-line', 'map-goal', 'map-obstacle', 'state-idle', 'state-driving',
      'state-holding', 'state-lost-place', 'state-error', 'state-silent',
    ];
    for (const name of names) {
      this.colours[name] = style.getPropertyValue(`--${name}`).trim();
    }
    this.colours.font = style.fontFamily;
  }
}
