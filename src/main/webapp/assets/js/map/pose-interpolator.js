import {angleDifference} from '../shared/angles.js';

const LONGEST = 1_000; // milliseconds over which a pose is reached
const JUMP = 2; // metres beyond which a robot was moved, not driving

const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)');

/**
 * Poses between two reports: each robot moves from where it is shown to where it is, in about the
 * time between its reports.
 */
export class PoseInterpolator {
  #transitions = new Map(); // by the robot's name

  /** @param robots with their newest poses */
  update(robots, now) {
    const gone = new Set(this.#transitions.keys());
    for (const {name, pose} of robots) {
      gone.delete(name);
      if (pose) {
        this.#transitions.set(name, this.#transition(name, pose, now));
      }
    }
    gone.forEach((name) => this.#transitions.delete(name));
  }

  /** Where to show the robot now; undefined while its pose is unknown. */
  poseOf(name, now) {
    const transition = this.#transitions.get(name);
    if (!transition) {
      return undefined;
    }
    const {from, to, begin, duration} = transition;
    const part = duration > 0 ? Math.min(1, Math.max(0, (now - begin) / duration)) : 1;
    return {
      x: from.x + part * (to.x - from.x),
      y: from.y + part * (to.y - from.y),
      theta: from.theta + part * angleDifference(from.theta, to.theta),
    };
  }

  /** Whether some robot is still shown short of its pose. */
  isMoving(now) {
    for (const {begin, duration} of this.#transitions.values()) {
      if (now - begin < duration) {
        return true;
      }
    }
    return false;
  }

  #transition(name, pose, now) {
    const before = this.#transitions.get(name);
    const from = this.poseOf(name, now) ?? pose;
    const isUnchanged =
      before && before.to.x === pose.x && before.to.y === pose.y && before.to.theta === pose.theta;
    if (isUnchanged) {
      return before;
    }
    const isJump = Math.hypot(pose.x - from.x, pose.y - from.y) > JUMP;
    const duration =
      reducedMotion.matches || !before || isJump ? 0 : Math.min(LONGEST, 1.1 * (now - before.begin));
    return {from: duration > 0 ? from : pose, to: pose, begin: now, duration};
  }
}
