import {follow} from './stream.js';
import {showTimes} from './times.js';

/** Milliseconds between two refreshes at least. */
const PACE = 1_000;

/** What the page is about: a change of it in the stream makes the page fetch that part anew. */
const {live: kind, name} = document.querySelector('#live').dataset;
const subjects = {
  tasks: ({tasks}) => tasks.map((task) => [task.id, task.state, task.robots, task.held]),
  task: ({tasks}) => tasks.find((task) => String(task.id) === name),
  robots: ({robots}) => robots.map(({state, task, doing, battery}) => [state, task, doing, Math.round(100 * battery)]),
  robot: ({robots}) => {
    const robot = robots.find((candidate) => candidate.name === name);
    return robot && {...robot, lastSeen: null, route: null};
  },
};

let shown;
let wanted = false;
let busy = false;

async function refresh() {
  if (busy || !wanted) {
    return;
  }
  busy = true;
  wanted = false;
  try {
    const answer = await fetch(location.href, {headers: {accept: 'text/html'}});
    const fresh = new DOMParser().parseFromString(await answer.text(), 'text/html').querySelector('#live');
    if (answer.ok && fresh) {
      showTimes(fresh);
      document.querySelector('#live').replaceWith(fresh);
    }
  } finally {
    setTimeout(() => {
      busy = false;
      refresh();
    }, PACE);
  }
}

follow((snapshot) => {
  const now = JSON.stringify(subjects[kind](snapshot));
  if (now !== shown) {
    wanted = true;
    shown = now;
    refresh();
  }
});
