import {createElement, setText, updateList} from '../shared/elements.js';
import {updateLinkList} from '../shared/link-list.js';
import {locale} from '../shared/locale.js';
import {address} from '../shared/server.js';
import {text} from '../shared/texts.js';

const MAX_EVENTS = 8;
const clock = new Intl.DateTimeFormat(locale, {timeStyle: 'medium'});
const metres = new Intl.NumberFormat(locale, {minimumFractionDigits: 2, maximumFractionDigits: 2});
const $ = (selector) => document.querySelector(selector);

/** Fills the lists beside a replay: the robots and loads at that time, and the latest events before it. */
export function updateReplayLists(robots, replay) {
  const {events} = replay;
  const seen = robots
    .map((robot) => [robot.name, replay.poseOf(robot.name)])
    .filter(([, pose]) => pose);
  updateLinkList($('#replay-robots'), seen.map(([name, pose]) => robotEntry(name, pose, events)));
  const {loads} = replay;
  updateLinkList($('#replay-loads'), loads.map(loadEntry));
  $('#replay-no-loads').hidden = replay.isLoading || loads.length > 0;
  updateList($('#replay-events'), events.slice(0, MAX_EVENTS), ({id}) => id, createEvent, () => {});
  setText($('#replay-no-robots'), text(replay.isLoading ? 'replay.loading' : 'replay.none'));
  $('#replay-no-robots').hidden = seen.length > 0;
  $('#replay-no-events').hidden = replay.isLoading || events.length > 0;
}

function robotEntry(name, {isMoving}, events) {
  const last = events.find(({robot}) => robot === name);
  return {
    key: `robot ${name}`,
    href: `robots/${encodeURIComponent(name)}`,
    state: isMoving ? 'DRIVING' : 'IDLE',
    letter: '',
    title: name,
    side: text(isMoving ? 'replay.driving' : 'replay.stopped'),
    sentence: last && (last.task ? `${text('replay.task', last.task)}: ${last.text}` : last.text),
  };
}

function loadEntry({load, task, at, robots}) {
  const where = at && text('replay.loadAt', metres.format(at.x), metres.format(at.y));
  return {
    key: `load ${load}`,
    href: `tasks/${task}`,
    state: '',
    letter: '',
    title: text('replay.task', task),
    side: where ?? text('replay.loadOn', robots.join(text('common.comma'))),
  };
}

function createEvent({at, text: sentence, task}) {
  const time = createElement('time', '', clock.format(new Date(at)));
  time.dateTime = at;
  const source = createElement('p', 'faint', time);
  if (task) {
    const link = createElement('a', '', text('replay.task', task));
    link.href = address(`tasks/${task}`);
    source.append(' · ', link);
  }
  return createElement('li', '', createElement('p', '', sentence), source);
}
