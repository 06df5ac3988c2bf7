import {FloorCanvas} from '../floor/floor-canvas.js';
import {Floor} from '../floor/floor.js';
import {drawArm} from '../map/arm.js';
import {PoseInterpolator} from '../map/pose-interpolator.js';

/** Points of the lines that are kept: some minutes. */
const MOST_POINTS = 2_000;

/** Metres between two of them at least. */
const SPACING = 0.01;

const NOSE_ANGLE = 0.8; // radians from the heading at which the robot's disc ends and its nose begins
const SMALLEST = 9; // pixels of a robot's radius

/** A robot on its floor, with where it was to drive and where it drove. */
export class ControlMap {
  #robot;
  #canvas;
  #floor; // undefined until it is loaded
  #isLoading = false;
  #here = []; // the robots of the floor
  #view; // the robot itself
  #desired = [];
  #actual = [];
  #poses = new PoseInterpolator();

  constructor(element, robot) {
    this.#robot = robot;
    this.#canvas = new FloorCanvas(element, this.#draw.bind(this));
  }

  /** @param version of the map that is in force */
  update(robots, view, version) {
    this.#view = view;
    this.#here = robots.filter(({floor}) => floor === view.floor);
    this.#poses.update(this.#here, performance.now());
    this.#record(view);
    if (!this.#isLoading && (this.#floor?.name !== view.floor || this.#floor.version !== version)) {
      this.#load(view.floor);
    }
    this.#canvas.requestFrame();
  }

  async #load(name) {
    this.#isLoading = true;
    try {
      const isOther = this.#floor?.name !== name;
      this.#floor = await Floor.load(name);
      if (isOther) {
        this.#canvas.viewport.setBounds(this.#floor.bounds);
        this.#desired = [];
        this.#actual = [];
      }
      this.#canvas.requestFrame();
    } catch {
      // the next snapshot makes up for it
    } finally {
      this.#isLoading = false;
    }
  }

  #record({pose, deviation}) {
    if (!pose) {
      return;
    }
    add(this.#actual, pose);
    if (deviation) { // its path lies beside it, across the direction of that
      const heading = pose.theta - deviation.heading;
      add(this.#desired, {
        x: pose.x + deviation.crossTrack * Math.sin(heading),
        y: pose.y - deviation.crossTrack * Math.cos(heading),
      });
    }
  }

  #draw(context, viewport, colours, now) {
    if (!this.#floor || !this.#view) {
      return false;
    }
    this.#floor.draw(context, viewport, colours);
    context.lineJoin = 'round';
    const line = (points, colour, width, dash, alpha) => {
      context.beginPath();
      points.forEach(({x, y}) => context.lineTo(...viewport.toScreen(x, y)));
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.globalAlpha = alpha;
      context.setLineDash(dash);
      context.stroke();
      context.setLineDash([]);
      context.globalAlpha = 1;
    };
    const {pose, route} = this.#view;
    line(this.#actual, colours['state-driving'], 4, [], 0.5);
    line(this.#desired, colours['map-goal'], 2, [6, 4], 1);
    if (pose && route.length > 0) {
      line([pose, ...route], colours['map-goal'], 2, [6, 4], 1);
    }
    for (const robot of this.#here) {
      this.#drawRobot(context, viewport, colours, robot, now);
    }
    return this.#poses.isMoving(now);
  }

  #drawRobot(context, viewport, colours, {name, footprint, arm}, now) {
    const pose = this.#poses.poseOf(name, now);
    if (!pose) {
      return;
    }
    const r = Math.max(SMALLEST, (footprint / 2) * viewport.scale);
    context.globalAlpha = name === this.#robot ? 1 : 0.45;
    context.save();
    context.translate(...viewport.toScreen(pose.x, pose.y));
    context.rotate(-pose.theta);
    context.beginPath();
    context.arc(0, 0, r, NOSE_ANGLE, 2 * Math.PI - NOSE_ANGLE);
    context.lineTo(1.6 * r, 0);
    context.closePath();
    context.fillStyle = colours[name === this.#robot ? 'state-driving' : 'state-silent'];
    context.strokeStyle = colours['map-halo'];
    context.lineWidth = 2;
    context.stroke();
    context.fill();
    context.restore();
    drawArm(context, viewport, colours, arm, pose);
    context.globalAlpha = 1;
  }
}

function add(points, point) {
  const last = points.at(-1);
  if (!last || Math.hypot(point.x - last.x, point.y - last.y) >= SPACING) {
    points.push(point);
    if (points.length > MOST_POINTS) {
      points.shift();
    }
  }
}
