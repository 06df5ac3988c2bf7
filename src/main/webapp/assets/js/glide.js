import {turn} from './turn.js';

const LONGEST = 1_000; // milliseconds over which a pose is reached
const JUMP = 2; // metres beyond which a robot was moved, not driving

const calm = matchMedia('(prefers-reduced-motion: reduce)');

/**
 * Poses between two reports: each robot glides from where it is shown to where it is, in about the
 * time between its reports.
 */
export class Glide {
  #paths = new Map();

  /** @param robots with their newest poses */
  update(robots, now) {
    const gone = new Set(this.#paths.keys());
    for (const {name, pose} of robots) {
      gone.delete(name);
      if (pose) {
        this.#paths.set(name, this.#path(name, pose, now));
      }
    }
    gone.forEach((name) => this.#paths.delete(name));
  }

  /** Where to show the robot now; undefined while its pose is unknown. */
  at(name, now) {
    const path = this.#paths.get(name);
    if (!path) {
      return undefined;
    }
    const part = path.time > 0 ? Math.min(1, Math.max(0, (now - path.begun) / path.time)) : 1;
    const {from, to} = path;
    return {
      x: from.x + part * (to.x - from.x),
      y: from.y + part * (to.y - from.y),
      theta: from.theta + part * turn(from.theta, to.theta),
    };
  }

  /** Whether some robot is still on its way to its pose. */
  isMoving(now) {
    return [...this.#paths.values()].some((path) => now - path.begun < path.time);
  }

  #path(name, pose, now) {
    const before = this.#paths.get(name);
    const from = this.at(name, now) ?? pose;
    const stands = before && before.to.x === pose.x && before.to.y === pose.y && before.to.theta === pose.theta;
    if (stands) {
      return before;
    }
    const jumps = Math.hypot(pose.x - from.x, pose.y - from.y) > JUMP;
    const time = calm.matches || !before || jumps ? 0 : Math.min(LONGEST, 1.1 * (now - before.begun));
    return {from: time > 0 ? from : pose, to: pose, begun: now, time};
  }
}
