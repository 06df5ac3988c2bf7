const HEIGHT = 14; // pixels of a line of text

const widths = new Map(); // pixels, by label and font
const MAX_WIDTHS = 2_000;

/** Sides of a sign, the better one first. */
const BELOW = [1, -1];
export const ABOVE = [-1, 1];

/** Text that can be read on any ground, in its own direction, whatever that of the page. */
export function drawLabel(context, colours, words, x, y, baseline, colour = colours['map-text']) {
  const label = `\u2068${words}\u2069`;
  context.font = `600 12px ${colours.font}`;
  context.textAlign = 'center';
  context.textBaseline = baseline;
  context.lineJoin = 'round';
  context.lineWidth = 3.5;
  context.strokeStyle = colours['map-halo'];
  context.strokeText(label, x, y);
  context.fillStyle = colour;
  context.fillText(label, x, y);
}

/** Labels of one frame that keep clear of each other: on one side of their sign, else on the other, else not. */
export class Labels {
  #context;
  #colours;
  #taken = [];

  constructor(context, colours) {
    this.#context = context;
    this.#colours = colours;
  }

  /**
   * @param half the sign's half width, pixels
   * @param sides where it stands, the better side first
   */
  draw(label, x, y, half, colour, sides = BELOW) {
    const width = this.#widthOf(label);
    const free = sides
      .map((side) => (side > 0 ? y + half + 3 : y - half - 3 - HEIGHT))
      .map((top) => ({left: x - width / 2, right: x + width / 2, top, bottom: top + HEIGHT}))
      .find((box) => !this.#taken.some((other) => overlap(box, other)));
    if (free) {
      this.#taken.push(free);
      drawLabel(this.#context, this.#colours, label, x, free.top, 'top', colour);
    }
  }

  #widthOf(label) {
    const key = `${this.#colours.font} ${label}`;
    let width = widths.get(key);
    if (width === undefined) {
      this.#context.font = `600 12px ${this.#colours.font}`;
      width = this.#context.measureText(label).width;
      if (widths.size >= MAX_WIDTHS) {
        widths.clear();
      }
      widths.set(key, width);
    }
    return width;
  }
}

function overlap(a, b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
