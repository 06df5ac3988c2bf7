import {element, showEntries, write} from './entries.js';
import {showLinks} from './links.js';
import {locale} from './locale.js';
import {address} from './server.js';
import {text} from './texts.js';

const MOST_EVENTS = 8;
const clock = new Intl.DateTimeFormat(locale, {timeStyle: 'medium'});
const $ = (selector) => document.querySelector(selector);

/** The lists beside a replay: where robots were, and what had happened. */
export function showThen(robots, replay) {
  const {events} = replay;
  const seen = robots
    .map((robot) => [robot.name, replay.poseOf(robot.name)])
    .filter(([, pose]) => pose);
  showLinks($('#then-robots'), seen.map(([name, pose]) => robotEntry(name, pose, events)));
  showEntries($('#then-events'), events.slice(0, MOST_EVENTS), ({id}) => id, makeEvent, () => {});
  write($('#then-none'), text(replay.isLoading ? 'replay.loading' : 'replay.none'));
  $('#then-none').hidden = seen.length > 0;
  $('#then-quiet').hidden = replay.isLoading || events.length > 0;
}

function robotEntry(name, {moves}, events) {
  const last = events.find(({robot}) => robot === name);
  return {
    key: `robot ${name}`,
    href: `robots/${encodeURIComponent(name)}`,
    state: moves ? 'DRIVING' : 'STOOD',
    letter: '',
    title: name,
    side: text(moves ? 'replay.drove' : 'replay.stood'),
    what: last && (last.task ? `${text('replay.task', last.task)}: ${last.text}` : last.text),
  };
}

function makeEvent({at, text: what, task}) {
  const time = element('time', '', clock.format(new Date(at)));
  time.dateTime = at;
  const source = element('p', 'faint', time);
  if (task) {
    const link = element('a', '', text('replay.task', task));
    link.href = address(`tasks/${task}`);
    source.append(' · ', link);
  }
  return element('li', '', element('p', '', what), source);
}
