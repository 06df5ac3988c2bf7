import {showTime, showTimes} from './times.js';

/** Milliseconds between two refreshes at least. */
const REFRESH_INTERVAL = 1_000;

/** The same for what robots publish by MQTT. */
const READINGS_INTERVAL = 5_000;

/** The same for devices of the network. */
const NETWORK_INTERVAL = 5_000;

/** The same for how a supervisor gets on. */
const SUPERVISION_INTERVAL = 5_000;

/** What each kind of region shows of a snapshot: when that changes, the region is fetched anew. */
const SUBJECTS = {
  tasks: ({tasks, queued}) => [queued, ...tasks.map((task) => [task.id, task.state, task.robots, task.held])],
  task: ({tasks}, name) => {
    const task = tasks.find((candidate) => String(candidate.id) === name);
    return task && [task, task.order && partsOf(tasks, task.order.id).map(({id, state}) => [id, state])];
  },
  order: ({tasks}, name) => partsOf(tasks, name),
  'order-actions': ({tasks}, name) => partsOf(tasks, name).map(({id, state}) => [id, state]),
  robots: ({robots}) => robots.map(({state, task, phase, doing, battery, pose, twist, maxLoad, host, port}) =>
    [state, task, phase, doing, Math.round(100 * battery), pose, twist?.v, twist?.u, maxLoad, host, port]),
  robot: ({robots}, name) => {
    const robot = robots.find((candidate) => candidate.name === name);
    return robot && {...robot, lastSeen: null, route: null};
  },
  control: ({robots}, name) => {
    const robot = robots.find((candidate) => candidate.name === name);
    return robot && [robot.state, robot.doing, robot.errors, robot.alert];
  },
  'task-actions': ({tasks}, name) => {
    const task = tasks.find((candidate) => String(candidate.id) === name);
    return task && [task.state, task.held, task.blocked, task.priority, task.needs];
  },
  'robot-readings': () => Math.floor(Date.now() / READINGS_INTERVAL), // they are in no snapshot
  'robot-battery': ({robots}, name) => Math.round(100 * robots.find((robot) => robot.name === name)?.battery),
  'robot-stop': ({robots}, name) => {
    const robot = robots.find((candidate) => candidate.name === name);
    return robot?.errors.filter(({clearable}) => clearable).map(({code}) => code);
  },
  'robot-actions': ({robots, pause}, name) => {
    const robot = robots.find((candidate) => candidate.name === name);
    return robot && [robot.held, robot.task, pause];
  },
  loads: ({tasks, floors}) => [
    ...tasks.map(({id, state, loadAt, robots}) => [id, state, loadAt, robots]),
    ...floors.map(({leftLoads}) => leftLoads),
  ],
  supervision: ({robots, tasks, floors}, name) => [
    floors.find(({floor}) => floor === name)?.boxes,
    tasks.filter(({floor}) => floor === name).map((task) => [task.id, task.state, task.robots, task.needs, task.waitingFor]),
    robots.filter(({floor}) => floor === name).map(({state, doing, battery}) => [state, doing, Math.round(100 * battery)]),
    Math.floor(Date.now() / SUPERVISION_INTERVAL), // idle seconds and what was seen are in no snapshot
  ],
  network: () => Math.floor(Date.now() / NETWORK_INTERVAL),
  pause: ({pause}) => pause,
  floors: ({floors}) => floors.map(({floor, hold}) => [floor, hold]),
  service: ({robots, floors}, name) => [
    robots.find((robot) => robot.name === name)?.state === 'OUT_OF_SERVICE',
    floors.some(({kept}) => kept.some(({robot}) => robot === name)),
  ],
};

/** The tasks of that order, as far as a snapshot has them. */
function partsOf(tasks, orderId) {
  return tasks.filter(({order}) => order && String(order.id) === String(orderId));
}

/** The parts of a page marked by data-live, which follow the fleet. */
class LiveRegions {
  #subjects = new Map(); // by the region's id, as JSON
  #outdated = new Set(); // ids of regions
  #isRefreshing = false;

  update(snapshot) {
    showAlerts(snapshot.alerts);
    showLastReports(snapshot.robots);
    for (const {id, dataset} of document.querySelectorAll('[data-live]')) {
      const subject = JSON.stringify(SUBJECTS[dataset.live](snapshot, dataset.name)) ?? '';
      if (subject !== this.#subjects.get(id)) {
        this.#subjects.set(id, subject);
        this.#outdated.add(id);
      }
    }
    this.#refresh();
  }

  async #refresh() {
    if (this.#isRefreshing || this.#outdated.size === 0) {
      return;
    }
    this.#isRefreshing = true;
    const ids = [...this.#outdated];
    this.#outdated.clear();
    try {
      const page = await pageOfNow();
      for (const id of page ? ids : []) {
        const fresh = page.getElementById(id);
        if (fresh) {
          showTimes(fresh);
          replace(document.getElementById(id), fresh);
        }
      }
    } catch {
      ids.forEach((id) => this.#outdated.add(id)); // the server is away for a moment
    } finally {
      setTimeout(() => {
        this.#isRefreshing = false;
        this.#refresh();
      }, REFRESH_INTERVAL);
    }
  }
}

/**
 * This page as the server has it now; null where it is no more.
 *
 * @throws {Error} when the server does not answer or cannot now
 */
async function pageOfNow() {
  const answer = await fetch(location.href, {headers: {accept: 'text/html', 'x-toqa-background': 'yes'}});
  if (answer.status >= 500 || answer.status === 429) {
    throw new Error(`The server answered ${answer.status}.`);
  }
  return answer.ok ? new DOMParser().parseFromString(await answer.text(), 'text/html') : null;
}

/** Replaces a region: what was open stays open, and the focus stays on what had it. */
function replace(old, fresh) {
  const nameOf = (disclosure) => disclosure.querySelector('summary').textContent;
  const open = [...old.querySelectorAll('details[open]')].map(nameOf);
  for (const disclosure of fresh.querySelectorAll('details')) {
    disclosure.open ||= open.includes(nameOf(disclosure));
  }
  if (fresh.isEqualNode(old)) {
    return; // a button that is being pressed must not be replaced
  }
  const focused = old.contains(document.activeElement) ? document.activeElement : null;
  const successor = focused && [...fresh.querySelectorAll('*')].find((element) => element.isEqualNode(focused));
  old.replaceWith(fresh);
  successor?.focus({preventScroll: true});
}

/** Reports come all the time: a region is not fetched anew for them. */
function showLastReports(robots) {
  for (const time of document.querySelectorAll('time[data-last-seen]')) {
    const robot = robots.find(({name}) => name === time.dataset.lastSeen);
    if (robot?.lastSeen) {
      time.dateTime = robot.lastSeen;
      showTime(time);
    }
  }
}

function showAlerts(alerts) {
  const place = document.getElementById('alerts');
  const shown = [...place?.children ?? []].map(({textContent}) => textContent.trim()); // innerText lays the page out
  if (place && shown.join('\n') !== alerts.join('\n')) {
    place.replaceChildren(...alerts.map((alert) => {
      const line = document.createElement('p');
      line.className = 'notice bad';
      line.textContent = alert;
      return line;
    }));
  }
}

const regions = new LiveRegions();

/** Fetches those live regions of the page anew whose subject differs from what they show. */
export function updateLiveRegions(snapshot) {
  regions.update(snapshot);
}
