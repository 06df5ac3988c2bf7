import {turn} from './turn.js';

const STANDS = 0.25; // metres between two points of a robot that stood in the time between them
const SILENT = 90_000; // milliseconds without a point after which nothing is known of one that moved
const TURNS = 1_000; // milliseconds in which a robot is shown to turn where its way bends

/**
 * Where a robot was, between the points that its track has. Its heading is that of its way, so it is
 * unknown until the robot has moved.
 */
export class Course {
  #points; // milliseconds since 1970, x and y in metres
  #headings = []; // of the way from each point to the next, radians

  /** @param points oldest first */
  constructor(points) {
    this.#points = points;
    let heading;
    points.slice(1).forEach(([, x, y], i) => {
      const [, fromX, fromY] = points[i];
      if (Math.hypot(x - fromX, y - fromY) > 0.05) {
        heading = Math.atan2(y - fromY, x - fromX);
      }
      this.#headings.push(heading);
    });
  }

  /** Its pose, and whether it moves; undefined where that is not known. */
  at(time) {
    const i = this.#last(time);
    if (i < 0) {
      return undefined;
    }
    const [begun, x, y] = this.#points[i];
    const [reached, toX, toY] = this.#points[i + 1] ?? [Infinity, x, y];
    if (Math.hypot(toX - x, toY - y) <= STANDS) {
      return {x, y, theta: this.#headings[i - 1], moves: false};
    }
    if (reached - begun > SILENT) {
      return undefined;
    }
    const part = (time - begun) / (reached - begun);
    return {x: x + part * (toX - x), y: y + part * (toY - y), theta: this.#heading(i, time - begun), moves: true};
  }

  #heading(i, since) {
    const before = this.#headings[i - 1] ?? this.#headings[i];
    return before + Math.min(1, since / TURNS) * turn(before, this.#headings[i]);
  }

  /** The index of the last point that is not after that time. */
  #last(time) {
    let [low, high] = [-1, this.#points.length - 1];
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      [low, high] = this.#points[middle][0] <= time ? [middle, high] : [low, middle - 1];
    }
    return low;
  }
}
