import {listenForGestures} from './gestures.js';
import {Viewport} from './viewport.js';

/** Custom properties of the style sheet that drawings use, without the dashes. */
const COLOURS = [
  'map-free', 'map-wall', 'map-line', 'map-text', 'map-halo', 'map-place', 'map-parking',
  'map-charging', 'map-load', 'map-load-line', 'map-goal', 'map-obstacle', 'state-idle', 'state-driving',
  'state-holding', 'state-lost-place', 'state-error', 'state-silent',
];

/**
 * A canvas that shows a floor: keeps its size, its colours and its viewport, and draws a frame
 * when one is requested.
 */
export class FloorCanvas {
  viewport = new Viewport();
  colours = {};
  #canvas;
  #draw;
  #isFrameRequested = false;

  /**
   * @param draw called with (context, viewport, colours, now); true requests the next frame too
   * @param onTap called with the map point of a click, and how many metres a pixel is
   * @param stroke as {@link listenForGestures} takes it
   */
  constructor(canvas, draw, onTap, stroke) {
    this.#canvas = canvas;
    this.#draw = draw;
    this.#readColours();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      this.#readColours();
      this.requestFrame();
    });
    new ResizeObserver(() => this.#resize()).observe(canvas);
    listenForGestures(
      canvas,
      this.viewport,
      () => this.requestFrame(),
      (px, py) => onTap?.(...this.viewport.toMap(px, py), 1 / this.viewport.scale),
      stroke,
    );
  }

  /** Draws with the next frame of the screen. */
  requestFrame() {
    if (!this.#isFrameRequested) {
      this.#isFrameRequested = true;
      requestAnimationFrame((now) => this.#drawFrame(now));
    }
  }

  #drawFrame(now) {
    this.#isFrameRequested = false;
    const context = this.#canvas.getContext('2d');
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, this.viewport.width, this.viewport.height);
    if (this.#draw(context, this.viewport, this.colours, now)) {
      this.requestFrame();
    }
  }

  #resize() {
    const {clientWidth, clientHeight} = this.#canvas;
    this.#canvas.width = Math.round(clientWidth * devicePixelRatio);
    this.#canvas.height = Math.round(clientHeight * devicePixelRatio);
    this.viewport.resize(clientWidth, clientHeight);
    this.requestFrame();
  }

  #readColours() {
    const style = getComputedStyle(document.documentElement);
    for (const name of COLOURS) {
      this.colours[name] = style.getPropertyValue(`--${name}`).trim();
    }
    for (const letter of document.querySelectorAll('.legend [data-state]')) {
      const colour = getComputedStyle(letter).getPropertyValue('--state').trim();
      this.colours[`state-${letter.dataset.state}`] = colour || this.colours['state-silent'];
    }
    this.colours.font = style.fontFamily;
  }
}
