import {angleDifference} from '../shared/angles.js';

const NEAR = 0.25; // metres from its path at which a track may show a robot, and a little more
const SAME_WAY = Math.PI / 3; // radians

/**
 * The rest of a path from where a robot was, as the live map has it: where the robot was comes first.
 * Where the path crosses itself, the piece counts that goes the way in which the robot went.
 *
 * @param points x and y, metres
 */
export function remainingPath(points, pose) {
  let best;
  for (let i = 1; i < points.length; i++) {
    const distance = distanceToPiece(pose, points[i - 1], points[i]);
    const penalty = distance < NEAR && isSameWay(pose, points[i - 1], points[i]) ? 0 : NEAR;
    if (best === undefined || distance + penalty < best.cost) {
      best = {next: i, cost: distance + penalty};
    }
  }
  return best ? [pose, ...points.slice(best.next).map(([x, y]) => ({x, y}))] : [];
}

function isSameWay({theta}, [fromX, fromY], [toX, toY]) {
  return theta === undefined
    || Math.abs(angleDifference(theta, Math.atan2(toY - fromY, toX - fromX))) < SAME_WAY;
}

function distanceToPiece({x, y}, [fromX, fromY], [toX, toY]) {
  const [alongX, alongY] = [toX - fromX, toY - fromY];
  const squared = alongX * alongX + alongY * alongY;
  const along = squared === 0 ? 0 : ((x - fromX) * alongX + (y - fromY) * alongY) / squared;
  const part = Math.min(1, Math.max(0, along));
  return Math.hypot(x - fromX - part * alongX, y - fromY - part * alongY);
}
