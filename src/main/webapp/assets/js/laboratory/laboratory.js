import '../shared/live.js';
import {setText} from '../shared/elements.js';
import {fetchJson} from '../shared/server.js';
import {MovingScene} from './moving-scene.js';

/** Milliseconds between two looks at runs that go on. */
const INTERVAL = 1_000;

const isOpen = ({dataset}) => dataset.runState === 'QUEUED' || dataset.runState === 'RUNNING';

/** Shows how far each run is that goes on; loads the page anew as soon as one has come further. */
async function watch() {
  const open = [...document.querySelectorAll('[data-run]')].filter(isOpen);
  if (open.length === 0) {
    return;
  }
  try {
    const runs = new Map((await fetchJson('api/v1/laboratory/runs')).map((run) => [run.id, run]));
    for (const element of open) {
      const run = runs.get(Number(element.dataset.run));
      if (run?.state !== element.dataset.runState && !isFillingIn()) {
        location.reload();
        return;
      }
      showProgress(element, run);
    }
  } catch {
    // a failure is made up for by the next look
  }
  setTimeout(watch, INTERVAL);
}

/** What somebody enters is not to be lost. */
function isFillingIn() {
  return document.querySelector('.experiment details[open], .heading details[open]') !== null;
}

function showProgress(element, run) {
  const bar = element.querySelector('progress');
  if (bar && run?.progress) {
    bar.value = run.progress.share;
    setText(element.querySelector('[data-step]'), run.progress.step);
  }
}

for (const scene of document.querySelectorAll('[data-motion]')) {
  fetchJson(scene.dataset.motion)
    .then((motion) => new MovingScene(scene, motion))
    .catch(() => {}); // the picture is there all the same
}
await watch();
