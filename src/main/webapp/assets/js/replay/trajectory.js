import {angleDifference} from '../shared/angles.js';

const STATIONARY = 0.25; // metres between two points of a robot that did not move in the time between them
const SILENCE = 90_000; // milliseconds without a point after which a moving robot's pose is unknown
const TURN_TIME = 1_000; // milliseconds in which a robot is shown to turn where its path bends

/**
 * The poses of a robot over time, interpolated between the points of its track. The heading is that
 * of the path, so it is unknown until the robot has moved.
 */
export class Trajectory {
  #points; // milliseconds since 1970, x and y in metres
  #headings = []; // from each point to the next, radians

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

  /** The pose at a time, and whether the robot is moving; undefined where that is not known. */
  poseAt(time) {
    const i = this.#lastIndexBefore(time);
    if (i < 0) {
      return undefined;
    }
    const [begin, x, y] = this.#points[i];
    const [end, toX, toY] = this.#points[i + 1] ?? [Infinity, x, y];
    if (Math.hypot(toX - x, toY - y) <= STATIONARY) {
      return {x, y, theta: this.#headings[i - 1], isMoving: false};
    }
    if (end - begin > SILENCE) {
      return undefined;
    }
    const part = (time - begin) / (end - begin);
    return {
      x: x + part * (toX - x),
      y: y + part * (toY - y),
      theta: this.#heading(i, time - begin),
      isMoving: true,
    };
  }

  #heading(i, elapsed) {
    const before = this.#headings[i - 1] ?? this.#headings[i];
    return before + Math.min(1, elapsed / TURN_TIME) * angleDifference(before, this.#headings[i]);
  }

  /** The index of the last point that is not after that time, by binary search; -1 if there is none. */
  #lastIndexBefore(time) {
    let [low, high] = [-1, this.#points.length - 1];
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      [low, high] = this.#points[middle][0] <= time ? [middle, high] : [low, middle - 1];
    }
    return low;
  }
}
