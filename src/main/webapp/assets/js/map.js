import {Board} from './board.js';
import {element, showEntries, write} from './entries.js';
import {drawRobots, drawTasks, isOpen, radius, thatStood} from './fleet.js';
import {Floor} from './floor.js';
import {Glide} from './glide.js';
import {drawCells, drawStandstills} from './hazards.js';
import {showLinks} from './links.js';
import {locale} from './locale.js';
import {showParts} from './parts.js';
import {Replay} from './replay.js';
import {address} from './server.js';
import {follow} from './stream.js';
import {text} from './texts.js';
import {showThen} from './then.js';

const $ = (selector) => document.querySelector(selector);
const percent = new Intl.NumberFormat(locale, {style: 'percent'});
const whole = new Intl.NumberFormat(locale);
const STATES = [
  'ERROR', 'NOT_LOCALISED', 'LOST', 'CONNECTING', 'OUT_OF_SERVICE', 'HOLDING', 'CHARGING', 'DRIVING',
  'IDLE',
];
/** What needs somebody, the most urgent first. */
const URGENCY = ['ERROR', 'question', 'standstill', 'LOST', 'NOT_LOCALISED', 'charger', 'refusal'];
const TOUCH = 12; // pixels from a load or a goal at which it is meant
const IN_NEED = new Set(['ERROR', 'NOT_LOCALISED', 'LOST']);

let floor;
let robots = [];
let tasks = [];
let queued = 0; // tasks in the queue, also those that are not sent
let floors = [];
let newest = 0; // milliseconds since 1970, by the server's clock
let changed = performance.now();
let isFirst = true; // until there was a snapshot
let connection; // undefined until it is known
const chosen = new Set(); // states to which the robots are narrowed down; none: all of them
const glide = new Glide();
const replay = new Replay(() => newest, () => floor.name, showReplay);

const board = new Board($('#map'), draw, followWhatIsAt);

function draw(context, viewport, colours, now) {
  if (!floor) {
    return false;
  }
  viewport.lead();
  $('#following').hidden = !viewport.isFollowing;
  floor.draw(context, viewport, colours);
  const here = robots.filter((robot) => robot.floor === floor.name);
  return replay.isOpen
    ? drawThen(context, viewport, colours, now, here)
    : drawNow(context, viewport, colours, now, here);
}

function drawNow(context, viewport, colours, now, here) {
  const view = floors.find((candidate) => candidate.floor === floor.name);
  const poseOf = (name) => glide.at(name, now);
  if (view) {
    drawCells(context, viewport, colours, floor, view);
  }
  const tasksHere = tasks.filter((task) => task.floor === floor.name);
  drawTasks(context, viewport, colours, tasksHere);
  const shown = here.map((robot) => ({...robot, faint: !isChosen(robot)}));
  drawRobots(context, viewport, colours, shown, tasksHere, poseOf);
  if (view) {
    drawStandstills(context, viewport, colours, view, here, poseOf);
  }
  return glide.isMoving(now);
}

function drawThen(context, viewport, colours, now, here) {
  const goesOn = replay.advance(now);
  const then = here.map((robot) => thatStood(robot, replay.poseOf(robot.name)));
  drawRobots(context, viewport, colours, then, [], (name) => replay.poseOf(name));
  return goesOn;
}

function followWhatIsAt(x, y, metresPerPixel) {
  const isNear = (point, pixels) =>
    point && Math.hypot(point.x - x, point.y - y) <= pixels * metresPerPixel;
  const robot = robots.find(
    (one) => one.floor === floor?.name && isNear(pointOfRobot(one.name), radius(board.viewport, one) + 4));
  const task = tasks.filter((one) => one.floor === floor?.name && isOpen(one) && !replay.isOpen)
    .find((one) => isNear(one.loadAt ?? one.start, TOUCH) || isNear(one.goal, TOUCH));
  if (robot) {
    followRobot(robot);
  } else if (task) {
    followTask(task);
  }
}

function followRobot({name}) {
  keepInTheMiddle(() => pointOfRobot(name), name, `robots/${encodeURIComponent(name)}`);
}

/** Its robot, or the leader of its robots; before there is one, its load. */
function followTask({id, name}) {
  keepInTheMiddle(
    () => {
      const task = tasks.find((one) => one.id === id);
      return task && (pointOfRobot(task.robots[0]) ?? task.loadAt ?? task.start);
    },
    name,
    `tasks/${id}`);
}

function keepInTheMiddle(pointOf, name, href) {
  const link = $('#following a');
  link.href = address(href);
  write(link.querySelector('bdi'), name);
  board.viewport.follow(pointOf);
  board.refresh();
}

/** What another page sent the reader here for, such as ?robot=r1. */
async function followWhatWasAskedFor() {
  const asked = new URLSearchParams(location.search);
  const robot = robots.find(({name}) => name === asked.get('robot'));
  const task = tasks.find(({id}) => String(id) === asked.get('task'));
  const place = robot?.floor ?? task?.floor;
  if (place && place !== floor.name) {
    $('#floor').value = place;
    await showFloor(place);
  }
  if (robot) {
    followRobot(robot);
  } else if (task) {
    followTask(task);
  }
}

function pointOfRobot(name) {
  return shownPose(name, performance.now());
}

function shownPose(name, now) {
  return replay.isOpen ? replay.poseOf(name) : glide.at(name, now);
}

function showSnapshot(snapshot) {
  ({robots, tasks, queued, floors} = snapshot);
  newest = Date.parse(snapshot.at);
  showParts(snapshot);
  changed = performance.now();
  glide.update(robots, changed);
  if (isFirst) {
    isFirst = false;
    followWhatWasAskedFor();
  }
  $('#replay-open').disabled = !floor;
  showNeeds();
  if (!replay.isOpen) {
    showNow();
  }
}

function showNow() {
  board.refresh();
  showCounts();
  showRobots();
  showTasks();
  showAge();
}

/** The page turns to the past, follows it, or turns back from it. */
function showReplay() {
  const past = replay.isOpen;
  $('#map').classList.toggle('past', past);
  for (const part of ['#counts', '#now']) {
    $(part).hidden = past;
  }
  for (const part of ['#then', '#needs-now']) {
    $(part).hidden = !past;
  }
  showAge();
  if (past) {
    board.refresh();
    showThen(robots.filter((robot) => robot.floor === floor.name), replay);
  } else {
    showNow();
  }
}

function isChosen({state}) {
  return chosen.size === 0 || chosen.has(state);
}

/** How many robots are in each state; a click narrows the robots down to it, another one widens them again. */
function showCounts() {
  const counts = STATES.map((state) => ({
    state,
    count: robots.filter((robot) => robot.state === state).length,
  })).filter(({state, count}) => count > 0 || chosen.has(state));
  showEntries($('#counts'), counts, ({state}) => state, makeCount, (item, {state, count}) => {
    write(item.querySelector('b'), whole.format(count));
    item.querySelector('button').ariaPressed = chosen.has(state);
  });
}

function makeCount({state}) {
  const letter = element('span', 'letter', text(`robot.letter.${state}`));
  letter.dataset.state = state;
  letter.ariaHidden = 'true';
  const button = element('button', '', letter, element('b'), ' ', element('span', '', text(`robot.state.${state}`)));
  button.type = 'button';
  button.addEventListener('click', () => {
    if (!chosen.delete(state)) {
      chosen.add(state);
    }
    showNow();
  });
  return element('li', '', button);
}

// Whom the robot did not let in: its fault, or undefined.
function stranger({errors}) {
  return errors.find(({code}) => code === 'REFUSED');
}

function isInNeed(robot) {
  return IN_NEED.has(robot.state) || robot.alert !== null || stranger(robot) !== undefined;
}

function robotEntry(robot) {
  return {
    key: `robot ${robot.name}`,
    href: `robots/${encodeURIComponent(robot.name)}`,
    state: robot.state,
    letter: text(`robot.letter.${robot.state}`),
    title: robot.name,
    side: robot.battery === null ? '' : percent.format(robot.battery),
    what: robot.alert ?? robot.doing,
    fault: robot.alert ? undefined : (stranger(robot) ?? robot.errors[0])?.text,
  };
}

function taskEntry(task) {
  return {
    key: `task ${task.id}`,
    href: `tasks/${task.id}`,
    state: task.state,
    letter: String(task.id),
    title: task.name,
    side: text(`task.state.${task.state}`),
    what: task.needs?.question ?? task.late ?? task.waitingFor ?? task.robots.join(text('common.comma')),
  };
}

function showRobots() {
  showLinks($('#robots'), robots.filter(isChosen).map(robotEntry));
  $('#no-robots').hidden = robots.length > 0;
}

function showTasks() {
  const open = tasks.filter(isOpen);
  showLinks($('#tasks'), open.map(taskEntry));
  $('#no-tasks').hidden = open.length > 0;
  const more = queued - open.filter((task) => task.state === 'QUEUED').length;
  write($('#more-tasks'), text('map.tasks.more', whole.format(more)));
  $('#more-tasks').hidden = more <= 0;
}

function standstillEntry({robots: names, since, text: what}) {
  return {
    key: `standstill ${since} ${names}`,
    href: `robots/${encodeURIComponent(names[0])}`,
    state: 'ERROR',
    letter: '!',
    title: text('map.standstill'),
    side: '',
    what,
  };
}

function chargerEntry({name, since, text: what}) {
  return {
    key: `charger ${since} ${name}`,
    href: 'history?kind=robot.charger-fails',
    state: 'ERROR',
    letter: '!',
    title: text('map.charger'),
    side: '',
    what,
  };
}

function need(kind, entry) {
  return {...entry, urgency: URGENCY.indexOf(kind)};
}

function showNeeds() {
  const entries = [
    ...floors.flatMap(({standstills}) => standstills.map((one) => need('standstill', standstillEntry(one)))),
    ...floors.flatMap(({faultyChargers}) => faultyChargers.map((one) => need('charger', chargerEntry(one)))),
    ...tasks.filter((task) => task.needs).map((task) => need('question', taskEntry(task))),
    ...robots
      .filter(isInNeed)
      .map((robot) => need(IN_NEED.has(robot.state) ? robot.state : 'refusal', robotEntry(robot))),
  ].sort((a, b) => a.urgency - b.urgency);
  showLinks($('#needs-list'), entries);
  $('#needs').hidden = entries.length === 0;
}

function showAge() {
  const age = $('#age');
  if (!connection) {
    return; // it says that it connects
  }
  age.dataset.state = replay.isOpen ? 'past' : connection;
  if (replay.isOpen) {
    write(age, text('replay.label'));
  } else if (connection === 'live') {
    const seconds = Math.round((performance.now() - changed) / 1000);
    write(age, `${text('map.live')} · ${text('map.age', whole.format(seconds))}`);
  } else {
    write(age, '');
  }
}

function showConnection(state) {
  connection = state;
  const live = state === 'live';
  $('#map').classList.toggle('old', !live);
  showAge();
  const banner = $('#banner');
  banner.hidden = live;
  if (!live) {
    banner.replaceChildren(text(`map.${state}`));
  }
  if (state === 'loggedOut') {
    const link = element('a', '', text('map.loggedOut.link'));
    link.href = address('?next=/map');
    banner.append(' ', link);
  }
}

async function showFloor(name) {
  try {
    floor = await Floor.load(name);
    board.viewport.show(floor.bounds);
    board.refresh();
    replay.changeFloor();
  } catch {
    $('#banner').hidden = false;
    $('#banner').textContent = text('map.failed');
  }
}

const zooms = {
  '#zoom-in': () => board.viewport.zoom(1.4),
  '#zoom-out': () => board.viewport.zoom(1 / 1.4),
  '#zoom-fit': () => board.viewport.fit(),
};
for (const [button, zoom] of Object.entries(zooms)) {
  $(button).addEventListener('click', () => {
    zoom();
    board.refresh();
  });
}
$('#let-go').addEventListener('click', () => {
  board.viewport.letGo();
  board.refresh();
});
$('#floor')?.addEventListener('change', (event) => showFloor(event.target.value));
setInterval(showAge, 1_000);
await showFloor($('#floor')?.value);
follow(showSnapshot, showConnection);
