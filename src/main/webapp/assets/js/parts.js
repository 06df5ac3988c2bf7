import {showTimes} from './times.js';

/** Milliseconds between two refreshes at least. */
const PACE = 1_000;

/** What a part of a page can be about: a change of it in the stream makes that part come anew. */
const subjects = {
  tasks: ({tasks, queued}) => [queued, ...tasks.map((task) => [task.id, task.state, task.robots, task.held])],
  task: ({tasks}, name) => tasks.find((task) => String(task.id) === name),
  robots: ({robots}) => robots.map(({state, task, doing, battery}) => [state, task, doing, Math.round(100 * battery)]),
  robot: ({robots}, name) => {
    const robot = robots.find((candidate) => candidate.name === name);
    return robot && {...robot, lastSeen: null, route: null};
  },
  wishes: ({tasks}, name) => {
    const task = tasks.find((candidate) => String(candidate.id) === name);
    return task && [task.state, task.held, task.priority, task.needs];
  },
  orders: ({robots, pause}, name) => {
    const robot = robots.find((candidate) => candidate.name === name);
    return robot && [robot.held, robot.task, pause];
  },
  pause: ({pause}) => pause,
  floors: ({floors}) => floors.map(({floor, hold}) => [floor, hold]),
  service: ({robots, floors}, name) => [
    robots.find((robot) => robot.name === name)?.state === 'OUT_OF_SERVICE',
    floors.some(({kept}) => kept.some(({robot}) => robot === name)),
  ],
};

const shown = new Map(); // by the part's id, what its subject was
const wanted = new Set(); // ids of the parts that are old
let busy = false;

const nameOf = (disclosure) => disclosure.querySelector('summary').textContent;

/** Puts a fresh part into the place of the old one: what was open stays open, what had the focus keeps it. */
function replace(old, fresh) {
  const open = [...old.querySelectorAll('details[open]')].map(nameOf);
  for (const disclosure of fresh.querySelectorAll('details')) {
    disclosure.open ||= open.includes(nameOf(disclosure));
  }
  if (fresh.isEqualNode(old)) {
    return; // whoever is just pressing a button in it shall find it
  }
  const focused = old.contains(document.activeElement) ? document.activeElement : null;
  const heir = focused && [...fresh.querySelectorAll('*')].find((element) => element.isEqualNode(focused));
  old.replaceWith(fresh);
  heir?.focus({preventScroll: true});
}

async function refresh() {
  if (busy || wanted.size === 0) {
    return;
  }
  busy = true;
  const ids = [...wanted];
  wanted.clear();
  try {
    const answer = await fetch(location.href, {headers: {accept: 'text/html'}});
    const page = new DOMParser().parseFromString(await answer.text(), 'text/html');
    for (const id of answer.ok ? ids : []) {
      const fresh = page.getElementById(id);
      if (fresh) {
        showTimes(fresh);
        replace(document.getElementById(id), fresh);
      }
    }
  } finally {
    setTimeout(() => {
      busy = false;
      refresh();
    }, PACE);
  }
}

function showAlerts(alerts) {
  const now = alerts.join('\n');
  const place = document.getElementById('alerts');
  if (place && place.innerText.trim() !== now) {
    place.replaceChildren(...alerts.map((alert) => {
      const line = document.createElement('p');
      line.className = 'notice bad';
      line.textContent = alert;
      return line;
    }));
  }
}

/** Lets those parts of the page come anew whose subject has changed. */
export function showParts(snapshot) {
  showAlerts(snapshot.alerts);
  for (const {id, dataset} of document.querySelectorAll('[data-live]')) {
    const now = JSON.stringify(subjects[dataset.live](snapshot, dataset.name)) ?? '';
    if (now !== shown.get(id)) {
      shown.set(id, now);
      wanted.add(id);
    }
  }
  refresh();
}
