const CLOSEST = 600;
const PADDING = 16;

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
  #fitted = true;
  #leader; // tells the map point that is kept in the middle, while there is one

  /** @param bounds of the floor, metres */
  show(bounds) {
    this.#bounds = bounds;
    this.fit();
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
    if (this.#fitted) {
      this.fit();
    }
  }

  /** The whole floor. */
  fit() {
    const b = this.#bounds;
    this.scale = this.#widest();
    this.x = b.x + b.width / 2;
    this.y = b.y + b.height / 2;
    this.#fitted = true;
    this.#leader = undefined;
  }

  /**
   * Keeps what moves in the middle, near enough to be seen, until somebody pans or fits.
   *
   * @param pointOf its map point; undefined while that is not known
   */
  follow(pointOf) {
    this.scale = Math.max(this.scale, 2 * this.#widest());
    this.#leader = pointOf;
    this.lead();
  }

  letGo() {
    this.#leader = undefined;
  }

  get isFollowing() {
    return this.#leader !== undefined;
  }

  /** Before each picture. */
  lead() {
    const point = this.#leader?.();
    if (point) {
      ({x: this.x, y: this.y} = point);
      this.#stay();
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
    this.#leader = undefined;
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.#stay();
  }

  /** Zooms so that what is under the canvas point stays there. */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.toMap(px, py);
    this.scale = Math.min(CLOSEST, Math.max(this.#widest() / 2, this.scale * factor));
    this.x = x - (px - this.width / 2) / this.scale;
    this.y = y + (py - this.height / 2) / this.scale;
    this.#stay();
  }

  #widest() {
    const b = this.#bounds;
    return Math.max(
      0.1,
      Math.min((this.width - 2 * PADDING) / b.width, (this.height - 2 * PADDING) / b.height),
    );
  }

  /** The middle of the canvas never leaves the floor. */
  #stay() {
    const b = this.#bounds;
    this.x = Math.min(b.x + b.width, Math.max(b.x, this.x));
    this.y = Math.min(b.y + b.height, Math.max(b.y, this.y));
    this.#fitted = false;
  }
}
