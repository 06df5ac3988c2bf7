const ENDED = new Set(['DONE', 'FAILED', 'CANCELLED']);

export function isOpen(task) {
  return !ENDED.has(task.state);
}

/** What the newest snapshot says. */
export class FleetState {
  robots = [];
  tasks = [];
  floors = [];
  queued = 0; // tasks in the queue, including those that are not sent
  time = 0; // milliseconds since 1970, by the server's clock

  update({robots, tasks, floors, queued, at}) {
    Object.assign(this, {robots, tasks, floors, queued, time: Date.parse(at)});
  }

  get openTasks() {
    return this.tasks.filter(isOpen);
  }

  robotsOn(floor) {
    return this.robots.filter((robot) => robot.floor === floor);
  }

  tasksOn(floor) {
    return this.tasks.filter((task) => task.floor === floor);
  }

  floor(name) {
    return this.floors.find(({floor}) => floor === name);
  }

  /**
   * A load that an ended task left on its floor, with the floor's name; undefined: none.
   *
   * @param task id of the task, or its digits
   */
  leftLoad(task) {
    return this.floors
      .flatMap(({floor, leftLoads}) => leftLoads.map((load) => ({...load, floor})))
      .find((load) => String(load.task) === String(task));
  }

  robot(name) {
    return this.robots.find((robot) => robot.name === name);
  }

  /** @param id a number, or its digits */
  task(id) {
    return this.tasks.find((task) => String(task.id) === String(id));
  }
}
