import {setText} from '../shared/elements.js';
import {address} from '../shared/server.js';
import {isOpen} from './fleet-state.js';
import {radius} from './robots.js';

const TOUCH = 12; // pixels around a load or a goal that select it

/** Keeps a robot or the load of a task in the middle of the map. */
export class Following {
  #bar;
  #canvas;
  #state;
  #poseOf;

  /**
   * @param bar says what is followed, and has the button that stops it
   * @param poseOf answers the pose at which a robot is shown
   */
  constructor(bar, canvas, state, poseOf) {
    this.#bar = bar;
    this.#canvas = canvas;
    this.#state = state;
    this.#poseOf = poseOf;
    bar.querySelector('button').addEventListener('click', () => {
      canvas.viewport.stopFollowing();
      canvas.requestFrame();
    });
  }

  showBar() {
    this.#bar.hidden = !this.#canvas.viewport.isFollowing;
  }

  /**
   * Follows the robot or the load at a map point, if there is one.
   *
   * @param floor name of the floor that is shown
   * @param withTasks whether tasks are shown too
   */
  followAt(x, y, metresPerPixel, floor, withTasks) {
    const isNear = (point, pixels) =>
      point && Math.hypot(point.x - x, point.y - y) <= pixels * metresPerPixel;
    const robot = this.#state.robotsOn(floor)
      .find((one) => isNear(this.#poseOf(one.name), radius(this.#canvas.viewport, one) + 4));
    const tasks = withTasks ? this.#state.tasksOn(floor).filter(isOpen) : [];
    const task = tasks.find((one) => isNear(one.loadAt ?? one.start, TOUCH) || isNear(one.goal, TOUCH));
    const load = withTasks
      ? this.#state.floor(floor)?.leftLoads.find((one) => isNear(one.where, TOUCH))
      : undefined;
    if (robot) {
      this.followRobot(robot);
    } else if (task) {
      this.followTask(task);
    } else if (load) {
      this.followLeftLoad(load);
    }
  }

  followRobot({name}) {
    this.#follow(() => this.#poseOf(name), name, `robots/${encodeURIComponent(name)}`);
  }

  /** Follows its robot, or the leader of its robots; while there is none, its load. */
  followTask({id, name}) {
    const point = () => {
      const task = this.#state.task(id);
      return task && (this.#poseOf(task.robots[0]) ?? task.loadAt ?? task.start);
    };
    this.#follow(point, name, `tasks/${id}`);
  }

  followLeftLoad({task, name, where}) {
    this.#follow(() => where, name, `tasks/${task}`);
  }

  #follow(point, name, href) {
    const link = this.#bar.querySelector('a');
    link.href = address(href);
    setText(link.querySelector('bdi'), name);
    this.#canvas.viewport.follow(point);
    this.#canvas.requestFrame();
  }
}
