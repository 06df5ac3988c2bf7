const CLOSEST = 600; // pixels a metre
const PADDING = 16; // pixels

/**
 * Which part of the map a canvas shows. Map coordinates are metres with y to the north, canvas
 * coordinates are CSS pixels with y downward.
 */
export class Viewport {
  width = 1;
  height = 1;
  scale = 1; // pixels a metre
  x = 0; // of the map point in the middle
  y = 0;
  #bounds = {x: 0, y: 0, width: 1, height: 1};
  #isFitted = true;
  #target; // answers the map point that is kept in the middle, while there is one

  /** @param bounds of the floor, metres */
  setBounds(bounds) {
    this.#bounds = bounds;
    this.fit();
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
    if (this.#isFitted) {
      this.fit();
    }
  }

  /** Shows the whole floor. */
  fit() {
    const b = this.#bounds;
    this.scale = this.#fittingScale;
    this.x = b.x + b.width / 2;
    this.y = b.y + b.height / 2;
    this.#isFitted = true;
    this.#target = undefined;
  }

  /**
   * Keeps a moving point in the middle, magnified, until the reader pans or fits.
   *
   * @param target answers the map point; undefined while it is not known
   */
  follow(target) {
    this.scale = Math.max(this.scale, 2 * this.#fittingScale);
    this.#target = target;
    this.centreOnTarget();
  }

  stopFollowing() {
    this.#target = undefined;
  }

  get isFollowing() {
    return this.#target !== undefined;
  }

  /** To be called before each frame. */
  centreOnTarget() {
    const point = this.#target?.();
    if (point) {
      ({x: this.x, y: this.y} = point);
      this.#keepOnFloor();
    }
  }

  toScreen(x, y) {
    return [
      this.width / 2 + (x - this.x) * this.scale,
      this.height / 2 - (y - this.y) * this.scale,
    ];
  }

  toMap(px, py) {
    return [
      this.x + (px - this.width / 2) / this.scale,
      this.y - (py - this.height / 2) / this.scale,
    ];
  }

  pan(dx, dy) {
    this.#target = undefined;
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.#keepOnFloor();
  }

  /** Zooms so that what is under the canvas point stays there. */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.toMap(px, py);
    this.scale = Math.min(CLOSEST, Math.max(this.#fittingScale / 2, this.scale * factor));
    this.x = x - (px - this.width / 2) / this.scale;
    this.y = y + (py - this.height / 2) / this.scale;
    this.#keepOnFloor();
  }

  /** The scale at which the whole floor is visible. */
  get #fittingScale() {
    const b = this.#bounds;
    return Math.max(
      0.1,
      Math.min((this.width - 2 * PADDING) / b.width, (this.height - 2 * PADDING) / b.height),
    );
  }

  /** The middle of the canvas never leaves the floor. */
  #keepOnFloor() {
    const b = this.#bounds;
    this.x = Math.min(b.x + b.width, Math.max(b.x, this.x));
    this.y = Math.min(b.y + b.height, Math.max(b.y, this.y));
    this.#isFitted = false;
  }
}
