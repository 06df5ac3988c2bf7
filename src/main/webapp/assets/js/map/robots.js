import {ABOVE, drawLabel, Labels} from '../floor/labels.js';
import {text} from '../shared/texts.js';
import {armPoints, drawArm, onMap} from './arm.js';
import {isOpen} from './fleet-state.js';

const SMALLEST = 11; // pixels of a robot's radius
const DOT = 5; // pixels of a robot's radius where many stand close
const MANY = 100; // robots in view from which on they may be dots
const CLOSE = 40; // pixels between two of them on average, below which they are
const URGENT = new Set(['ERROR', 'NOT_LOCALISED', 'LOST']); // never dots
const MARGIN = 80; // pixels beside the map from which a robot and its name reach into it
const NOSE_ANGLE = 0.8; // radians from the heading at which the robot's disc ends and its nose begins
const COLOURS = {}; // those of states are the legend's
for (const {dataset: {state}} of document.querySelectorAll('.legend [data-state]')) {
  COLOURS[state] = `state-${state}`;
}

/** Draws loads that are not on a robot, and goals. */
export function drawTasks(context, viewport, colours, tasks) {
  const open = tasks.filter(isOpen);
  drawGoals(context, viewport, colours, open.filter(({state}) => state !== 'RETURNING'));
  for (const task of open) {
    if (task.kind !== 'DRIVE' && (task.state !== 'CARRYING' || task.loadAt)) {
      const {x, y} = task.state === 'RETURNING'
        ? (task.arm?.place ?? task.goal)
        : (task.loadAt ?? task.arm?.pick ?? task.start);
      drawLoad(context, viewport.toScreen(x, y), 0, loadHalf(viewport, task), colours);
    }
  }
}

/** Draws loads that ended tasks left on the floor; how each is turned is not known. */
export function drawLeftLoads(context, viewport, colours, loads) {
  for (const load of loads) {
    drawLoad(context, viewport.toScreen(load.where.x, load.where.y), 0, loadHalf(viewport, load), colours);
  }
}

/** Draws boxes that a supervisor has found, with the numbers on them; those at their targets are faint. */
export function drawBoxes(context, viewport, colours, boxes) {
  for (const {box, where, delivered} of boxes) {
    const at = viewport.toScreen(where.x, where.y);
    const half = loadHalf(viewport, {});
    context.globalAlpha = delivered ? 0.55 : 1;
    drawLoad(context, at, 0, half, colours);
    context.globalAlpha = 1;
    drawLabel(context, colours, String(box), at[0], at[1], 'middle');
  }
}

/**
 * A robot as a replay shows it: of its state only whether it was moving is known, of its path not
 * how much of it was released, and of its arm nothing.
 *
 * @param route the points that it had ahead
 * @param task of the load that it carried; undefined: none
 */
export function replayedRobot(robot, pose, route, task) {
  const state = pose?.isMoving ? 'DRIVING' : 'IDLE';
  return {...robot, state, letter: '', route, released: 0, task, arm: null};
}

/**
 * Where many stand close together, as dots in the colours of their states, without names, loads and paths; those that
 * a person must see to in full.
 *
 * @param poseOf answers the pose at which a robot is shown
 * @param heldLoads where robots hold the loads that several carry
 */
export function drawRobots(context, viewport, colours, robots, tasks, poseOf, heldLoads = []) {
  const placed = robots.map((robot) => [robot, poseOf(robot.name)]).filter(([, pose]) => pose);
  const inView = placed.filter(([, pose]) => isInView(viewport, pose));
  const isCrowd = areClose(viewport, inView);
  if (isCrowd) {
    drawDots(context, viewport, colours, inView.filter(([robot]) => !URGENT.has(robot.state)));
  }
  const seen = isCrowd ? inView.filter(([robot]) => URGENT.has(robot.state)) : inView;
  for (const [robot, pose] of isCrowd ? seen : placed) {
    drawRoute(context, viewport, colours, robot, pose);
  }
  for (const task of tasks.filter(({state, robots: team}) => state === 'CARRYING' && team.length > 1)) {
    const points = heldLoads.find((held) => held.task === task.id)?.points ?? [];
    drawGroup(context, viewport, colours, task, task.robots.map(poseOf).filter((pose) => pose), points);
  }
  const carriedOf = new Map(tasks.filter(({state}) => state === 'CARRYING').map((task) => [task.id, task]));
  for (const [robot, pose] of seen) {
    const carried = carriedOf.get(robot.task);
    if (carried?.robots.length === 1) {
      const at = viewport.toScreen(...handOf(robot, pose));
      drawLoad(context, at, -pose.theta, loadHalf(viewport, carried, robot), colours);
    }
    context.globalAlpha = robot.faint ? 0.25 : 1;
    drawRobot(context, viewport, colours, robot, pose);
    drawArm(context, viewport, colours, robot.arm, pose);
    context.globalAlpha = 1;
  }
  drawNames(context, viewport, colours, seen);
}

function isInView(viewport, {x, y}) {
  const [left, top] = viewport.toScreen(x, y);
  return left > -MARGIN && left < viewport.width + MARGIN && top > -MARGIN && top < viewport.height + MARGIN;
}

/** Whether robots are many, and on average closer to each other than that their letters could be told apart. */
function areClose(viewport, inView) {
  if (inView.length < MANY) {
    return false;
  }
  const points = inView.map(([, {x, y}]) => [x, y]);
  const extent = (side) => points.reduce(
    ([least, most], point) => [Math.min(least, point[side]), Math.max(most, point[side])], [Infinity, -Infinity]);
  const [width, height] = [0, 1].map((side) => extent(side)).map(([least, most]) => (most - least) * viewport.scale);
  return width * height < inView.length * CLOSE ** 2;
}

/** Those in one state at once. */
function drawDots(context, viewport, colours, seen) {
  const groups = new Map();
  for (const one of seen) {
    const key = `${one[0].state} ${one[0].faint ?? false}`;
    if (!groups.has(key)) {
      groups.set(key, []);
    }
    groups.get(key).push(one);
  }
  context.lineWidth = 2;
  for (const group of groups.values()) {
    const [{state, faint}] = group[0];
    const colour = colours[COLOURS[state]];
    context.globalAlpha = faint ? 0.25 : 1;
    context.beginPath();
    for (const [, pose] of group) {
      const [x, y] = viewport.toScreen(pose.x, pose.y);
      context.moveTo(x + DOT, y);
      context.arc(x, y, DOT, 0, 2 * Math.PI);
    }
    const isDisconnected = state === 'LOST' || state === 'CONNECTING';
    context.strokeStyle = isDisconnected ? colour : colours['map-halo'];
    context.stroke();
    context.fillStyle = isDisconnected ? colours['map-free'] : colour;
    context.fill();
  }
  context.globalAlpha = 1;
}

/**
 * Of robots that stand close together not all have room for their names, those that the filter lets through first; the
 * list beside the map has all.
 */
function drawNames(context, viewport, colours, seen) {
  const labels = new Labels(context, colours);
  for (const [robot, pose] of seen.toSorted(([a], [b]) => Number(a.faint ?? false) - Number(b.faint ?? false))) {
    const [x, y] = viewport.toScreen(pose.x, pose.y);
    context.globalAlpha = robot.faint ? 0.25 : 1;
    labels.draw(robot.name, x, y, 1.75 * radius(viewport, robot) - 3, undefined, ABOVE);
  }
  context.globalAlpha = 1;
}

/** Where what a robot carries is: in its hand, or on it. */
function handOf(robot, pose) {
  return (robot.arm?.load ? armPoints(robot.arm, pose)?.at(-1) : null) ?? [pose.x, pose.y];
}

/** Pixels from a robot's centre to its edge. */
export function radius(viewport, robot) {
  return Math.max(SMALLEST, (robot.footprint / 2) * viewport.scale);
}

function drawRoute(context, viewport, colours, robot, pose) {
  if (robot.route.length === 0) {
    return;
  }
  const points = [pose, ...robot.route].map(({x, y}) => viewport.toScreen(x, y));
  if (!reachesIntoView(viewport, points)) {
    return;
  }
  const line = (from, to) => {
    context.beginPath();
    points.slice(from, to).forEach(([x, y]) => context.lineTo(x, y));
    context.stroke();
  };
  context.strokeStyle = colours[COLOURS[robot.state]];
  context.lineJoin = 'round';
  context.lineCap = 'butt'; // hundreds of dashes with round ends take several times longer
  context.globalAlpha = 0.55;
  context.lineWidth = 2;
  context.setLineDash([5, 4]);
  line(robot.released, points.length);
  context.setLineDash([]);
  context.lineCap = 'round';
  context.globalAlpha = 0.75;
  context.lineWidth = 4;
  line(0, robot.released + 1);
  context.globalAlpha = 1;
}

/** Whether the box around these points and the map have something in common. */
function reachesIntoView(viewport, points) {
  const [xs, ys] = [0, 1].map((side) => points.map((point) => point[side]));
  return Math.max(...xs) > 0 && Math.min(...xs) < viewport.width
    && Math.max(...ys) > 0 && Math.min(...ys) < viewport.height;
}

/** Draws a robot as a disc with a nose that points ahead; its colour and its letter show its state. */
function drawRobot(context, viewport, colours, robot, pose) {
  const [x, y] = viewport.toScreen(pose.x, pose.y);
  const r = radius(viewport, robot);
  const isDisconnected = robot.state === 'LOST' || robot.state === 'CONNECTING';
  const colour = colours[COLOURS[robot.state]];
  context.save();
  context.translate(x, y);
  context.strokeStyle = colours['map-halo'];
  context.lineWidth = 2.5;
  context.beginPath();
  if (pose.theta === undefined) {
    context.arc(0, 0, r, 0, 2 * Math.PI);
  } else {
    context.rotate(-pose.theta);
    context.arc(0, 0, r, NOSE_ANGLE, 2 * Math.PI - NOSE_ANGLE);
    context.lineTo(1.75 * r, 0);
  }
  context.closePath();
  context.stroke();
  context.fillStyle = isDisconnected ? colours['map-free'] : colour;
  context.fill();
  if (isDisconnected) {
    context.strokeStyle = colour;
    context.setLineDash([4, 3]);
    context.stroke();
  }
  context.restore();
  context.fillStyle = isDisconnected ? colour : '#fff';
  context.font = `700 ${Math.max(11, 1.1 * r)}px ${colours.font}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(robot.letter ?? text(`robot.letter.${robot.state}`), x, y + 0.05 * r);
}

/** Draws a load in the middle of the robots that carry it together, with the heading of their leader. */
function drawGroup(context, viewport, colours, task, poses, points) {
  if (poses.length < task.robots.length) {
    return;
  }
  const leader = viewport.toScreen(poses[0].x, poses[0].y);
  context.strokeStyle = colours['map-load-line'];
  context.lineWidth = 2;
  for (const follower of poses.slice(1)) {
    context.beginPath();
    context.moveTo(...leader);
    context.lineTo(...viewport.toScreen(follower.x, follower.y));
    context.stroke();
  }
  const load = loadAmong(task, poses, points);
  drawLoad(context, viewport.toScreen(load.x, load.y), -load.theta, loadHalf(viewport, task), colours);
  drawHoldPoints(context, viewport, colours, load, points);
}

/** Where robots carry a load together: each of them says it by its place, and the mean counts. */
function loadAmong(task, poses, points) {
  const {theta} = poses[0];
  const placeOf = (robot) => points.find((point) => point.robot === robot)?.place ?? {x: 0, y: 0};
  const middles = task.robots.map((robot, i) => onMap({...poses[i], theta}, [-placeOf(robot).x, -placeOf(robot).y]));
  const mean = (side) => middles.reduce((sum, middle) => sum + middle[side], 0) / middles.length;
  return {x: mean(0), y: mean(1), theta};
}

/** Where robots hold the load: the larger what a robot bears, as it measures or else its share, the larger its dot. */
function drawHoldPoints(context, viewport, colours, load, points) {
  const borne = ({share, measured}) => measured ?? share;
  const largest = Math.max(...points.map(borne));
  for (const point of points) {
    const {at} = point;
    const [cos, sin] = [Math.cos(load.theta), Math.sin(load.theta)];
    const [x, y] = viewport.toScreen(load.x + cos * at.x - sin * at.y, load.y + sin * at.x + cos * at.y);
    context.beginPath();
    context.arc(x, y, 2 + 3 * Math.sqrt(borne(point) / largest), 0, 2 * Math.PI);
    context.fillStyle = colours['map-load-line'];
    context.strokeStyle = colours['map-halo'];
    context.lineWidth = 1.5;
    context.fill();
    context.stroke();
  }
}

/** Half of the load's length and width in pixels. */
function loadHalf(viewport, task, robot) {
  const least = robot ? 1.25 * radius(viewport, robot) : 7;
  const {length = 0.3, width = 0.3} = task.size ?? {};
  return [length, width].map((side) => Math.max(least, (side / 2) * viewport.scale));
}

function drawLoad(context, [x, y], angle, [halfLength, halfWidth], colours) {
  context.save();
  context.translate(x, y);
  context.rotate(angle);
  context.beginPath();
  context.roundRect(-halfLength, -halfWidth, 2 * halfLength, 2 * halfWidth, 3);
  context.fillStyle = colours['map-load'];
  context.strokeStyle = colours['map-load-line'];
  context.lineWidth = 1.5;
  context.fill();
  context.stroke();
  context.restore();
}

/** All rings at once, and all dots in them. */
function drawGoals(context, viewport, colours, tasks) {
  const rings = new Path2D();
  const dots = new Path2D();
  for (const {goal} of tasks) {
    const [x, y] = viewport.toScreen(goal.x, goal.y);
    rings.moveTo(x + 9, y);
    rings.arc(x, y, 9, 0, 2 * Math.PI);
    dots.moveTo(x + 3, y);
    dots.arc(x, y, 3, 0, 2 * Math.PI);
  }
  context.strokeStyle = colours['map-goal'];
  context.fillStyle = colours['map-goal'];
  context.lineWidth = 2;
  context.stroke(rings);
  context.fill(dots);
}
